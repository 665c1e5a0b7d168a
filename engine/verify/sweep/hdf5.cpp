// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/sweep/hdf5.hpp"

#include "algebra/number/error.hpp"
#include "model/text/diagnostic.hpp"

#ifdef RESONFORM_HDF5
#include <dlfcn.h>
#include <hdf5.h>

#include <algorithm>
#include <cstddef>
#endif

namespace resonform {

#ifndef RESONFORM_HDF5

std::string why_no_hdf5() { return "resonform was built without it (Debian: libhdf5-dev)"; }

std::vector<std::uint64_t> write_hdf5(const std::filesystem::path& file, const Hdf5Frame&) {
    bad_input(Reason::file, {"HDF5 files are written by the library HDF5", why_no_hdf5(),
                             "write .npy or .csv", whole_file(file)});
}

#else

namespace {

constexpr unsigned truncate = 2; // H5F_ACC_TRUNC, which as a macro calls the library

// What is taken of the library. Its constants are variables, which have values after H5open.
class Library {
public:
    Library() : library_(dlopen(RESONFORM_HDF5, RTLD_NOW | RTLD_LOCAL)) {
        const char* const error = library_ == nullptr ? dlerror() : nullptr; // NOLINT(concurrency-mt-unsafe)
        if (error != nullptr) missing_ = error;
        if (library_ == nullptr) return;
        take("H5open", open);
        take("H5Eset_auto2", on_error);
        take("H5Fcreate", create_file);
        take("H5Fclose", close_file);
        take("H5Gcreate2", create_group);
        take("H5Gclose", close_group);
        take("H5Pcreate", create_list);
        take("H5Pclose", close_list);
        take("H5Pset_obj_track_times", track_times);
        take("H5Pset_libver_bounds", bound_version);
        take("H5Pset_file_locking", lock_file);
        take("H5Pset_alloc_time", allocate_at);
        take("H5Pset_fill_time", fill_at);
        take("H5Screate_simple", create_space);
        take("H5Sclose", close_space);
        take("H5Tcopy", copy_type);
        take("H5Tset_size", set_size);
        take("H5Tclose", close_type);
        take("H5Acreate2", create_attribute);
        take("H5Awrite", write_attribute);
        take("H5Aclose", close_attribute);
        take("H5Dcreate2", create_array);
        take("H5Dwrite", write_array);
        take("H5Dget_offset", offset_of);
        take("H5Dclose", close_array);
        if (missing_.empty() && open() < 0) missing_ = "H5open fails";
    }

    [[nodiscard]] const std::string& missing() const { return missing_; }
    // A variable of the library, "H5T_C_S1_g".
    [[nodiscard]] hid_t constant(const char* name) const {
        const auto* const value = static_cast<const hid_t*>(dlsym(library_, name));
        return value == nullptr ? H5I_INVALID_HID : *value;
    }

    decltype(&H5open) open = nullptr;
    decltype(&H5Eset_auto2) on_error = nullptr;
    decltype(&H5Fcreate) create_file = nullptr;
    decltype(&H5Fclose) close_file = nullptr;
    decltype(&H5Gcreate2) create_group = nullptr;
    decltype(&H5Gclose) close_group = nullptr;
    decltype(&H5Pcreate) create_list = nullptr;
    decltype(&H5Pclose) close_list = nullptr;
    decltype(&H5Pset_obj_track_times) track_times = nullptr;
    decltype(&H5Pset_libver_bounds) bound_version = nullptr;
    decltype(&H5Pset_file_locking) lock_file = nullptr;
    decltype(&H5Pset_alloc_time) allocate_at = nullptr;
    decltype(&H5Pset_fill_time) fill_at = nullptr;
    decltype(&H5Screate_simple) create_space = nullptr;
    decltype(&H5Sclose) close_space = nullptr;
    decltype(&H5Tcopy) copy_type = nullptr;
    decltype(&H5Tset_size) set_size = nullptr;
    decltype(&H5Tclose) close_type = nullptr;
    decltype(&H5Acreate2) create_attribute = nullptr;
    decltype(&H5Awrite) write_attribute = nullptr;
    decltype(&H5Aclose) close_attribute = nullptr;
    decltype(&H5Dcreate2) create_array = nullptr;
    decltype(&H5Dwrite) write_array = nullptr;
    decltype(&H5Dget_offset) offset_of = nullptr;
    decltype(&H5Dclose) close_array = nullptr;

private:
    template <class Function> void take(const char* name, Function& function) {
        function = reinterpret_cast<Function>(dlsym(library_, name));
        if (function == nullptr && missing_.empty()) missing_ = std::string(name) + " is not in it";
    }

    void* library_; // never closed: it registers a function that runs at exit
    std::string missing_;
};

const Library& library() {
    static const Library loaded;
    return loaded;
}

// A handle of the library, closed at the end of its scope.
class Handle {
public:
    using Close = herr_t (*)(hid_t);
    Handle(hid_t id, Close closed_by, const std::filesystem::path& file) : id_(id), close_(closed_by) {
        if (id_ < 0) fail(file);
    }
    ~Handle() {
        if (id_ >= 0) (void)close_(id_);
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    operator hid_t() const { return id_; } // as the library takes it
    void close(const std::filesystem::path& file) {
        if (close_(std::exchange(id_, H5I_INVALID_HID)) < 0) fail(file);
    }
    [[noreturn]] static void fail(const std::filesystem::path& file) {
        bad_input(Reason::file, {"the output must be a file in a folder that exists and can be written",
                                 "HDF5 cannot write it",
                                 "free space, or give another path; the blocks are kept", whole_file(file)});
    }

private:
    hid_t id_;
    Close close_;
};

class Writer {
public:
    explicit Writer(std::filesystem::path file)
        : path_(std::move(file)), access_(list("H5P_CLS_FILE_ACCESS_ID_g")), file_(created()) {}

    // One text as a scalar of one element, several as an array of texts of one length.
    void attribute(const std::string& name, const std::vector<std::string>& texts) {
        std::size_t length = 1;
        for (const std::string& text : texts) length = std::max(length, text.size());
        std::string bytes;
        for (const std::string& text : texts) bytes += text + std::string(length - text.size(), '\0');
        const Handle type(h_.copy_type(h_.constant("H5T_C_S1_g")), h_.close_type, path_);
        check(h_.set_size(type, length));
        const Handle space = this->space({texts.size()});
        const Handle attribute(
            h_.create_attribute(file_, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
            h_.close_attribute, path_);
        check(h_.write_attribute(attribute, type, bytes.data()));
    }

    // A group of arrays.
    void group(const std::string& name) {
        const Handle properties = list("H5P_CLS_GROUP_CREATE_ID_g");
        check(h_.track_times(properties, false));
        const Handle made(h_.create_group(file_, name.c_str(), H5P_DEFAULT, properties, H5P_DEFAULT),
                          h_.close_group, path_);
    }

    // Returns its offset in the file.
    std::uint64_t array(const Hdf5Array& array) {
        const Handle properties = list("H5P_CLS_DATASET_CREATE_ID_g");
        check(h_.track_times(properties, false));
        check(h_.allocate_at(properties, H5D_ALLOC_TIME_EARLY));
        check(h_.fill_at(properties, H5D_FILL_TIME_NEVER));
        const Handle space = this->space(array.shape);
        const hid_t type = h_.constant("H5T_IEEE_F64LE_g");
        const Handle made(
            h_.create_array(file_, array.name.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT),
            h_.close_array, path_);
        if (!array.numbers.empty())
            check(h_.write_array(made, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, array.numbers.data()));
        const haddr_t offset = h_.offset_of(made);
        if (offset == HADDR_UNDEF) Handle::fail(path_);
        return offset;
    }

    void close() { file_.close(path_); }

private:
    [[nodiscard]] Handle list(const char* of) const {
        return {h_.create_list(h_.constant(of)), h_.close_list, path_};
    }
    [[nodiscard]] Handle space(const std::vector<std::uint64_t>& shape) const {
        const std::vector<hsize_t> lengths(shape.begin(), shape.end());
        return {h_.create_space(static_cast<int>(lengths.size()), lengths.data(), nullptr), h_.close_space,
                path_};
    }
    [[nodiscard]] Handle created() const {
        (void)h_.on_error(H5E_DEFAULT, nullptr, nullptr); // it is told in one message, not by the library
        check(h_.bound_version(access_, H5F_LIBVER_EARLIEST, H5F_LIBVER_V18));
        check(h_.lock_file(access_, false, true)); // some file systems have no locks
        return {h_.create_file(path_.c_str(), truncate, H5P_DEFAULT, access_), h_.close_file, path_};
    }
    void check(herr_t answer) const {
        if (answer < 0) Handle::fail(path_);
    }

    const Library& h_ = library();
    std::filesystem::path path_;
    Handle access_, file_;
};

} // namespace

std::string why_no_hdf5() { return library().missing(); }

std::vector<std::uint64_t> write_hdf5(const std::filesystem::path& file, const Hdf5Frame& frame) {
    Writer writer(file);
    for (const auto& [name, texts] : frame.attributes) writer.attribute(name, texts);
    std::vector<std::string> groups;
    std::vector<std::uint64_t> offsets;
    for (const Hdf5Array& array : frame.arrays) {
        const std::string group = array.name.substr(0, array.name.find('/'));
        if (group != array.name && std::find(groups.begin(), groups.end(), group) == groups.end()) {
            groups.push_back(group);
            writer.group(group);
        }
        offsets.push_back(writer.array(array));
    }
    writer.close();
    return offsets;
}

#endif

} // namespace resonform
