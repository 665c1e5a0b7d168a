// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/error.hpp"
#include "support/error_when.hpp"
#include "support/shell.hpp"
#include "verify/run/cache.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace resonform {
namespace {

TEST(Cache, HashIsFowlerNollVo) { // published values of FNV-1a with 128 bits
    EXPECT_EQ(content_hash(""), "6c62272e07bb014262b821756295c58d");
    EXPECT_EQ(content_hash("a"), "d228cb696f1a8caf78912b704e4a8964");
    EXPECT_EQ(content_hash("foobar"), "343e1662793c64bf6f0d3597ba446f18");
}

TEST(Cache, ReadsBackWhatWasStored) {
    const test::Scratch scratch;
    const auto file = scratch.path() / "sub" / "entry";
    const std::string payload("\n\0binary\n", 9);
    EXPECT_EQ(load_checked(file), std::nullopt);
    store_checked(file, payload);
    EXPECT_EQ(load_checked(file), payload);
}

TEST(Cache, DraftsOfProgramsThatAreGoneAreRemoved) {
    const test::Scratch scratch;
    const auto entry = scratch.path() / "entry";
    write_atomically(entry, "text");
    const auto draft = [&](const std::string& owner) {
        const auto file = std::filesystem::path(entry) += "." + owner + ".part";
        write_atomically(file, "half");
        return file;
    };
    const auto gone = draft("2000000000"), here = draft(std::to_string(getpid())), other = draft("x");
    const pid_t ended = fork(); // and not waited for
    if (ended == 0) _exit(0);
    siginfo_t reported;
    ASSERT_EQ(waitid(P_PID, static_cast<id_t>(ended), &reported, WEXITED | WNOWAIT), 0);
    const auto zombie = draft(std::to_string(ended));
    remove_abandoned_drafts(entry.parent_path());
    EXPECT_EQ(waitpid(ended, nullptr, 0), ended);
    for (const auto& file : {gone, zombie}) EXPECT_FALSE(std::filesystem::exists(file)) << file;
    for (const auto& file : {entry, here, other}) EXPECT_TRUE(std::filesystem::exists(file)) << file;
    remove_abandoned_drafts(entry.parent_path() / "absent");
}

TEST(Cache, DamagedFilesReadAsAbsent) {
    const test::Scratch scratch;
    const auto file = scratch.path() / "entry";
    store_checked(file, "0123456789");
    const std::string whole = read_bytes(file).value();
    for (std::size_t i = 0; i < whole.size(); ++i) {
        std::string damaged = whole;
        damaged[i] = static_cast<char>(damaged[i] ^ 1);
        write_atomically(file, damaged);
        EXPECT_EQ(load_checked(file), std::nullopt) << "byte " << i;
        write_atomically(file, whole.substr(0, i));
        EXPECT_EQ(load_checked(file), std::nullopt) << "cut at " << i;
    }
}

TEST(Cache, SaysThatItCannotWrite) {
    const test::Scratch scratch;
    const auto blocked = scratch.path() / "blocked";
    write_atomically(blocked, "a file where a folder is wanted");
    const Error error = test::error_when([&] { store_checked(blocked / "entry", "payload"); });
    EXPECT_EQ(error.diagnostic().rule, "the folder of cached results can be written");
    EXPECT_EQ(error.diagnostic().place.file, blocked.string());
}

} // namespace
} // namespace resonform
