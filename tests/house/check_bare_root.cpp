// SPDX-License-Identifier: GPL-3.0-or-later
// scripts/check_bare_root.sh removes the folder of its roots, and no other. Here `rm` writes down what it is
// to remove, and removes nothing.
#include "support/shell.hpp"

#include <gtest/gtest.h>

namespace resonform::test {

namespace {

namespace fs = std::filesystem;

class BareRoot : public testing::Test {
protected:
    BareRoot() {
        stub("rm", "echo \"$@\" >>'" + (scratch_.path() / "removed").string() + "'");
        stub("id", "echo 0");
        stub("apt-get", "echo no-mirror");
        stub("debootstrap", "exit 9"); // behind the removal
        fs::create_directory(scratch_.path() / "home");
    }
    // What was to be removed, "" if nothing was; the outcome is kept.
    std::string removed_for(const std::string& root) {
        fs::remove(scratch_.path() / "removed");
        outcome_ = run("HOME=$PWD/home PATH=$PWD/bin:$PATH RESONFORM_BARE_ROOT='" + root + "' " +
                           RESONFORM_SOURCE_DIR + "/scripts/check_bare_root.sh demo",
                       scratch_.path());
        return read(scratch_.path() / "removed");
    }
    [[nodiscard]] std::string in_scratch(const std::string& name) const {
        return (fs::canonical(scratch_.path()) / name).string();
    }
    Scratch scratch_;
    Outcome outcome_{};

private:
    void stub(const std::string& name, const std::string& body) const {
        const fs::path file = scratch_.path() / "bin" / name;
        write(file, "#!/bin/bash\n" + body + "\n");
        fs::permissions(file, fs::perms::owner_all);
    }
};

} // namespace

TEST_F(BareRoot, RefusesWhatIsNotItsOwn) {
    const std::string repository = RESONFORM_SOURCE_DIR;
    write(scratch_.path() / "letters/to_me", "dear");
    write(scratch_.path() / "file", "");
    for (const std::string& root : {std::string("/"), std::string("/.."), repository, repository + "/",
                                    repository + "/..", repository + "/engine", in_scratch("home"),
                                    in_scratch(""), in_scratch("letters"), in_scratch("file")}) {
        EXPECT_EQ(removed_for(root), "") << root;
        EXPECT_EQ(outcome_.code, 2) << root;
        EXPECT_EQ(outcome_.err.rfind(
                      "check_bare_root.sh: RESONFORM_BARE_ROOT: the folder, which is removed, must ", 0),
                  0U)
            << outcome_.err;
    }
    for (const std::string& root : {std::string("/"), repository, repository + "/..", in_scratch("home")}) {
        EXPECT_EQ(removed_for(root), "") << root;
        EXPECT_NE(outcome_.err.find("must not hold /"), std::string::npos) << outcome_.err;
    }
    EXPECT_EQ(removed_for(in_scratch("file")), "");
    EXPECT_NE(outcome_.err.find("\n  found: " + in_scratch("file") + "\n  hint:  give another folder"),
              std::string::npos)
        << outcome_.err;
}

TEST_F(BareRoot, TakesItsOwn) {
    fs::create_directory(scratch_.path() / "empty");
    for (const std::string name : {"new", "empty", "new", "empty"}) { // the second time they are not empty
        EXPECT_EQ(removed_for(in_scratch(name)), "-rf " + in_scratch(name) + "\n") << outcome_.err;
        EXPECT_EQ(outcome_.code, 9) << outcome_.err;
    }
}

} // namespace resonform::test
