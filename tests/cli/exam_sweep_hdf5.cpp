// SPDX-License-Identifier: GPL-3.0-or-later
// F.h5 as another program reads it: by the library HDF5.
#include "support/command.hpp"

#ifdef RESONFORM_HDF5
#include <dlfcn.h>
#include <hdf5.h>

#include <cstring>
#endif

namespace resonform::test {

namespace {

const std::string grid = "--over 'eps=log(1e-3:1e-1:3)' --over amplitude.x=0.5:1:2 ";

using SweepHdf5 = SweepOfSpring;

#ifdef RESONFORM_HDF5

constexpr unsigned read_only = 0; // H5F_ACC_RDONLY, which as a macro calls the library

class Reader {
public:
    explicit Reader(const std::filesystem::path& path) : library_(dlopen(RESONFORM_HDF5, RTLD_NOW)) {
        call<decltype(H5open)>("H5open")();
        file_ = call<decltype(H5Fopen)>("H5Fopen")(path.c_str(), read_only, H5P_DEFAULT);
    }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
    ~Reader() { call<decltype(H5Fclose)>("H5Fclose")(file_); }

    struct Array {
        std::vector<hsize_t> shape;
        std::vector<double> numbers;
    };
    Array array(const char* name) {
        const hid_t data = call<decltype(H5Dopen2)>("H5Dopen2")(file_, name, H5P_DEFAULT);
        EXPECT_GE(data, 0) << name;
        const hid_t space = call<decltype(H5Dget_space)>("H5Dget_space")(data);
        Array array;
        array.shape.resize(static_cast<std::size_t>(
            call<decltype(H5Sget_simple_extent_ndims)>("H5Sget_simple_extent_ndims")(space)));
        call<decltype(H5Sget_simple_extent_dims)>("H5Sget_simple_extent_dims")(space, array.shape.data(),
                                                                               nullptr);
        std::size_t count = 1;
        for (const hsize_t length : array.shape) count *= length;
        array.numbers.resize(count);
        const hid_t real = *static_cast<hid_t*>(dlsym(library_, "H5T_IEEE_F64LE_g"));
        EXPECT_GE(call<decltype(H5Dread)>("H5Dread")(data, real, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                                                     array.numbers.data()),
                  0);
        call<decltype(H5Dclose)>("H5Dclose")(data);
        return array;
    }
    // The texts of an attribute without what fills them up.
    std::vector<std::string> texts(const char* name) {
        const hid_t attribute = call<decltype(H5Aopen)>("H5Aopen")(file_, name, H5P_DEFAULT);
        EXPECT_GE(attribute, 0) << name;
        const hid_t type = call<decltype(H5Aget_type)>("H5Aget_type")(attribute);
        const std::size_t length = call<decltype(H5Tget_size)>("H5Tget_size")(type);
        std::string bytes(call<decltype(H5Aget_storage_size)>("H5Aget_storage_size")(attribute), '\0');
        EXPECT_GE(call<decltype(H5Aread)>("H5Aread")(attribute, type, bytes.data()), 0);
        std::vector<std::string> texts;
        for (std::size_t at = 0; at < bytes.size(); at += length) {
            const std::string one = bytes.substr(at, length);
            texts.push_back(one.substr(0, one.find('\0')));
        }
        call<decltype(H5Aclose)>("H5Aclose")(attribute);
        return texts;
    }

private:
    template <class Function> Function* call(const char* name) const {
        return reinterpret_cast<Function*>(dlsym(library_, name));
    }
    void* library_;
    hid_t file_ = -1;
};

#endif

} // namespace

#ifdef RESONFORM_HDF5

TEST_F(SweepHdf5, HoldsWhatTheOthersHold) {
    const Outcome outcome =
        shell("sweep " + grid + "--t 0,1/3 --output a.h5 && resonform sweep --gather a.npy");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    Reader reader(scratch_.path() / "a.h5");
    const Reader::Array values = reader.array("values");
    EXPECT_EQ(values.shape, (std::vector<hsize_t>{3, 2, 2, 1}));
    const std::string npy = file("a.npy");
    ASSERT_EQ(values.numbers.size(), 12U);
    EXPECT_EQ(std::memcmp(npy.data() + 128, values.numbers.data(), 12 * sizeof(double)), 0);
    EXPECT_EQ(reader.array("axes/eps").numbers, (std::vector<double>{0.001, 0.01, 0.1}));
    EXPECT_EQ(reader.array("axes/amplitude.x").numbers, (std::vector<double>{0.5, 1}));
    EXPECT_EQ(reader.array("t").numbers, (std::vector<double>{0, 1.0 / 3}));
    EXPECT_EQ(reader.texts("what"), std::vector<std::string>{"values"});
    EXPECT_EQ(reader.texts("axes"), (std::vector<std::string>{"eps", "amplitude.x"}));
    EXPECT_EQ(reader.texts("outputs"), std::vector<std::string>{"x"});
    EXPECT_EQ(reader.texts("version").size(), 1U);
}

TEST_F(SweepHdf5, QuantitiesAndEndsOfIntervals) {
    ASSERT_EQ(shell("sweep --over eps=0.1 --over amplitude.x=0.5 --what verify --output a.h5").code, 0);
    Reader reader(scratch_.path() / "a.h5");
    const Reader::Array values = reader.array("values");
    EXPECT_EQ(values.shape, (std::vector<hsize_t>{1, 1, 2, 1}));
    EXPECT_EQ(values.numbers[1], 3);
    EXPECT_EQ(reader.array("t").shape, (std::vector<hsize_t>{1, 1}));
    EXPECT_EQ(reader.array("t").numbers, std::vector<double>{5});
    EXPECT_EQ(reader.texts("quantities"), (std::vector<std::string>{"error", "order"}));
}

// No time of writing is in it, nor what was in the place of the file before.
TEST_F(SweepHdf5, HasTheSameBytesAfterARestart) {
    const std::string points = "--over eps=1e-4:0.5:500 --over phase.x=0:1:3 --output ";
    const Outcome outcome =
        shell("sweep " + points + "a.h5 >said; for i in 2 1; do sweep " + points +
              "b.h5 --shard $i/2 --jobs 3 >said; done; sleep 1.1; "
              "resonform sweep --gather b >said; cmp a.h5 b.h5 && echo same\n"
              "rm b.parts/00000007.block; sweep " +
              points + "b.h5 >said; cmp a.h5 b.h5 && echo same; ls b.parts | grep -c part$");
    EXPECT_EQ(outcome.out, "same\nsame\n0\n") << outcome.err;
}

TEST_F(SweepHdf5, AFileThatCannotBeWrittenIsSaidInOneMessage) {
    const Outcome outcome = shell("sweep " + grid +
                                  "--output a.h5 >said 2>&1; rm a.h5; mkdir a.h5\n"
                                  "resonform sweep --gather a.h5");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.err.find("resonform: a.h5: the output must be a file"), 0U) << outcome.err;
}

#else

TEST_F(SweepHdf5, WithoutTheLibraryItIsSaid) {
    const Outcome outcome = shell("sweep " + grid + "--output a.h5");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.err.find("resonform: --output: HDF5 cannot be written here\n"), 0U) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(scratch_.path() / "a.parts"));
}

#endif

} // namespace resonform::test
