// SPDX-License-Identifier: GPL-3.0-or-later
#include "house/include_graph.hpp"

#include <algorithm>

namespace resonform::test {

namespace {

std::string unit_of(const std::string& path) { return path.substr(0, path.rfind('.')); }

// Tarjan's strongly connected components.
class LoopSearch {
public:
    explicit LoopSearch(const IncludeGraph& graph) : graph_(graph) {
        for (const auto& [unit, included] : graph)
            if (visits_.find(unit) == visits_.end()) visit(unit);
        std::sort(found_.begin(), found_.end());
    }

    std::vector<std::vector<std::string>> found() && { return std::move(found_); }

private:
    struct Visit {
        std::size_t number, lowest; // reached from here
        bool open = true;
    };

    void visit(const std::string& unit) {
        const std::size_t number = visits_.size();
        Visit& here = visits_.emplace(unit, Visit{number, number}).first->second;
        path_.push_back(unit);
        for (const std::string& next : graph_.at(unit)) {
            if (graph_.find(next) == graph_.end()) continue; // a text made by the build
            if (visits_.find(next) == visits_.end()) visit(next);
            if (const Visit& there = visits_.at(next); there.open)
                here.lowest = std::min(here.lowest, there.lowest);
        }
        if (here.lowest == here.number) close(unit);
    }

    void close(const std::string& first) {
        const auto begin = std::find(path_.begin(), path_.end(), first);
        std::vector<std::string> component(begin, path_.end());
        path_.erase(begin, path_.end());
        for (const std::string& unit : component) visits_.at(unit).open = false;
        std::sort(component.begin(), component.end());
        if (component.size() > 1) found_.push_back(std::move(component));
    }

    const IncludeGraph& graph_;
    std::map<std::string, Visit> visits_;
    std::vector<std::string> path_;
    std::vector<std::vector<std::string>> found_;
};

} // namespace

IncludeGraph include_graph(const std::vector<SourceFile>& files) {
    IncludeGraph graph;
    for (const SourceFile& file : files) {
        const std::string unit = unit_of(file.path.substr(std::string("engine/").size()));
        std::set<std::string>& included = graph[unit];
        for (const std::string& line : file.lines)
            if (const auto path = included_file(line); path && unit_of(*path) != unit)
                included.insert(unit_of(*path));
    }
    return graph;
}

std::vector<std::vector<std::string>> loops(const IncludeGraph& graph) { return LoopSearch(graph).found(); }

} // namespace resonform::test
