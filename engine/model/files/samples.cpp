// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/samples.hpp"

#include "algebra/number/error.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/nearest.hpp"
#include "model/text/toml_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace resonform {

namespace {

constexpr int highest_degree = 15;
constexpr std::size_t most_points = 1000; // a panel of an integral for each, at least

std::string trimmed(const std::string& text) {
    const std::size_t begin = text.find_first_not_of(" \t\r"), end = text.find_last_not_of(" \t\r");
    return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    for (std::size_t begin = 0;;) {
        const std::size_t comma = line.find(',', begin);
        cells.push_back(trimmed(line.substr(begin, comma == std::string::npos ? comma : comma - begin)));
        if (comma == std::string::npos) return cells;
        begin = comma + 1;
    }
}

class SampleReader {
public:
    SampleReader(const TomlNode& node, const std::filesystem::path& scene) : node_(node) {
        check_keys(node, {"data", "columns", "degree"});
        const TomlNode& data = required("data", "data = \"omega.csv\"");
        samples_.file = string_of(data);
        path_ = scene.parent_path() / samples_.file;
        text_ = at_place(place_of(data.source), [&] { return read_text(path_); });
        const TomlNode& columns = required("columns", "columns = [\"tau\", \"omega\"]");
        if (columns.type != TomlNode::Type::array || columns.items.size() != 2)
            bad_value(columns, "'columns' names the column of the arguments and that of the values",
                      "write columns = [\"tau\", \"omega\"]");
        for (std::size_t k = 0; k < 2; ++k) samples_.columns[k] = string_of(columns.items[k]);
        columns_ = &columns;
        read_degree();
    }

    Samples read() {
        std::size_t line = 0;
        for (std::size_t begin = 0; begin < text_.size();) {
            const std::size_t end = std::min(text_.find('\n', begin), text_.size());
            read_line(text_.substr(begin, end - begin), static_cast<int>(++line));
            begin = end + 1;
        }
        check();
        return std::move(samples_);
    }

private:
    const TomlNode& required(const std::string& key, const std::string& hint) const {
        const TomlNode* found = node_.find(key);
        if (found == nullptr)
            bad_value(node_, "data of a function have the keys data, columns and degree", "add " + hint);
        return *found;
    }

    void read_degree() {
        const TomlNode& degree = required("degree", "degree = 5");
        samples_.degree = integer_of(degree, 1, highest_degree);
        if (samples_.degree % 2 == 0)
            bad_value(degree, "the degree of a spline is odd",
                      fmt::format("write degree = {}", samples_.degree + 1));
    }

    [[noreturn]] void bad_line(int line, const std::string& rule, const std::string& found,
                               const std::string& hint) const {
        bad_input({rule, found, hint, {path_.string(), line, 0, "", ""}});
    }

    void read_line(const std::string& text, int line) {
        if (trimmed(text).empty()) return;
        const std::vector<std::string> cells = cells_of(text);
        if (header_.empty()) {
            header_ = cells;
            for (std::size_t k = 0; k < 2; ++k) index_[k] = column(k);
            return;
        }
        if (cells.size() != header_.size())
            bad_line(line, "every line of the data has a value for each column",
                     fmt::format("{} values, {} columns", cells.size(), header_.size()),
                     "complete the line, or remove it");
        for (std::size_t k = 0; k < 2; ++k)
            (k == 0 ? samples_.x : samples_.y).push_back(number(cells[index_[k]], line));
        lines_.push_back(line);
    }

    [[nodiscard]] std::size_t column(std::size_t k) const {
        const auto found = std::find(header_.begin(), header_.end(), samples_.columns[k]);
        if (found == header_.end())
            bad_input(Reason::name, {"a column is named in the first line of " + samples_.file,
                                     in_quotes(samples_.columns[k]), suggest(samples_.columns[k], header_),
                                     place_of(columns_->items[k].source)});
        return static_cast<std::size_t>(found - header_.begin());
    }

    [[nodiscard]] double number(const std::string& cell, int line) const {
        double value = 0;
        const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
        if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value))
            bad_line(line, "data are finite numbers", in_quotes(cell), "write it as in 0.25 or 2.5e-1");
        return value;
    }

    void check() {
        std::vector<double>& x = samples_.x;
        const std::size_t least = static_cast<std::size_t>(samples_.degree) + 1;
        if (x.size() < least || x.size() > most_points)
            bad_value(node_,
                      fmt::format("a spline of degree {} goes through {} to {} points", samples_.degree,
                                  least, most_points),
                      fmt::format("{} has {}: give {}", samples_.file, x.size(),
                                  x.size() < least ? "more, or a lower degree" : "fewer"));
        const bool descends = x[1] < x[0];
        for (std::size_t k = 1; k < x.size(); ++k) {
            const std::string pair = fmt::format("{} after {}", x[k], x[k - 1]);
            if (x[k] == x[k - 1])
                bad_line(lines_[k], "every argument of the data stands there once", pair,
                         "remove one of the two");
            if ((x[k] < x[k - 1]) != descends)
                bad_line(lines_[k], "the arguments of the data rise from line to line, or fall", pair,
                         "sort the lines");
        }
        if (!descends) return;
        std::reverse(x.begin(), x.end());
        std::reverse(samples_.y.begin(), samples_.y.end());
    }

    const TomlNode& node_;
    const TomlNode* columns_ = nullptr;
    Samples samples_;
    std::filesystem::path path_;
    std::string text_;
    std::vector<std::string> header_;
    std::array<std::size_t, 2> index_{};
    std::vector<int> lines_; // of the samples
};

} // namespace

Samples read_samples(const TomlNode& node, const std::filesystem::path& scene) {
    return SampleReader(node, scene).read();
}

} // namespace resonform
