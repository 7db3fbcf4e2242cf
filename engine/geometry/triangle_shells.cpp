#include "engine/geometry/triangle_shells.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <tuple>
#include <utility>

namespace hanei {
namespace {

class Groups {
public:
    explicit Groups(std::size_t count) : leader_(count) { std::iota(leader_.begin(), leader_.end(), std::size_t{0}); }
    std::size_t of(std::size_t item) {
        while (leader_[item] != item) item = leader_[item] = leader_[leader_[item]];
        return item;
    }
    void join(std::size_t a, std::size_t b) {
        a = of(a);
        b = of(b);
        leader_[std::max(a, b)] = std::min(a, b);  // the first stays: an order that needs no luck
    }

private:
    std::vector<std::size_t> leader_;
};

/// An edge as one triangle runs through it.
struct EdgeUse {
    int low = 0, high = 0;
    std::size_t triangle = 0;
    int side = 0;          ///< of the triangle: from corner `side` to the next
    bool forward = false;  ///< from low to high, as the soup winds it
    auto key() const { return std::tuple(low, high, triangle, side); }
    bool is_same_edge(const EdgeUse& other) const { return low == other.low && high == other.high; }
};

class ShellFinder {
public:
    explicit ShellFinder(const TriangleSoup& soup)
        : soup_(soup),
          patches_(soup.triangles.size()),
          corners_(3 * soup.triangles.size()),
          shells_(soup.triangles.size()),
          turned_(soup.triangles.size(), false),
          contradictory_(soup.triangles.size(), false),
          joined_(soup.triangles.size(), 0) {}

    std::vector<TriangleShell> find() {
        list_uses();
        orient_patches();
        for_each_edge([&](std::size_t begin, std::size_t end) { join_around(begin, end); });
        return collect();
    }

private:
    void list_uses() {
        for (std::size_t t = 0; t < soup_.triangles.size(); ++t)
            for (int k = 0; k < 3; ++k) {
                const int a = soup_.triangles[t].corner[static_cast<std::size_t>(k)];
                const int b = soup_.triangles[t].corner[static_cast<std::size_t>((k + 1) % 3)];
                uses_.push_back({std::min(a, b), std::max(a, b), t, k, a < b});
            }
        std::sort(uses_.begin(), uses_.end(), [](const EdgeUse& a, const EdgeUse& b) { return a.key() < b.key(); });
    }

    template <class Do>
    void for_each_edge(Do act) {
        for (std::size_t begin = 0; begin < uses_.size();) {
            std::size_t end = begin;
            while (end < uses_.size() && uses_[end].is_same_edge(uses_[begin])) ++end;
            act(begin, end);
            begin = end;
        }
    }

    /// Within a patch, triangles joined by edges of two, all are turned to agree with the first; then
    /// all of them once more if most were turned.
    void orient_patches() {
        std::vector<std::vector<std::pair<std::size_t, bool>>> neighbours(soup_.triangles.size());
        for_each_edge([&](std::size_t begin, std::size_t end) {
            if (end - begin != 2) return;
            const EdgeUse& a = uses_[begin];
            const EdgeUse& b = uses_[begin + 1];
            const bool disagree = a.forward == b.forward;
            neighbours[a.triangle].emplace_back(b.triangle, disagree);
            neighbours[b.triangle].emplace_back(a.triangle, disagree);
            patches_.join(a.triangle, b.triangle);
        });
        std::vector<bool> seen(soup_.triangles.size(), false);
        for (std::size_t first = 0; first < soup_.triangles.size(); ++first) {
            if (seen[first]) continue;
            seen[first] = true;
            std::vector<std::size_t> patch{first};
            for (std::size_t k = 0; k < patch.size(); ++k)
                for (const auto& [other, disagree] : neighbours[patch[k]]) {
                    const bool turned = turned_[patch[k]] != disagree;
                    if (seen[other] && turned_[other] != turned) contradictory_[patches_.of(first)] = true;
                    if (seen[other]) continue;
                    seen[other] = true;
                    turned_[other] = turned;
                    patch.push_back(other);
                }
            const auto count = std::count_if(patch.begin(), patch.end(), [&](std::size_t t) { return turned_[t]; });
            if (2 * static_cast<std::size_t>(count) > patch.size())
                for (const std::size_t t : patch) turned_[t] = !turned_[t];
        }
    }

    bool runs_forward(const EdgeUse& use) const { return use.forward != turned_[use.triangle]; }

    const Vec3& at(int vertex) const { return soup_.vertices[static_cast<std::size_t>(vertex)]; }

    /// Around the edge, space behind a front ends where a triangle runs forward and begins where one
    /// runs backward: like brackets.
    void join_around(std::size_t begin, std::size_t end) {
        if (end - begin == 2) return join(uses_[begin], uses_[begin + 1]);
        if (end - begin < 2) return;
        const Vec3 from = at(uses_[begin].low);
        const Vec3 along = glm::normalize(at(uses_[begin].high) - from);
        const auto away = [&](const EdgeUse& use) {
            const int third = soup_.triangles[use.triangle].corner[static_cast<std::size_t>((use.side + 2) % 3)];
            const Vec3 v = at(third) - from;
            return v - glm::dot(v, along) * along;
        };
        const Vec3 first = away(uses_[begin]);
        constexpr double steps = 1e6;  // a radian's: triangles less apart lie on each other
        const double turn = 2.0 * std::numbers::pi * steps;
        std::vector<std::tuple<long, bool, std::size_t>> order;
        for (std::size_t k = begin; k < end; ++k) {
            const Vec3 v = away(uses_[k]);
            const double angle = std::atan2(glm::dot(glm::cross(first, v), along), glm::dot(first, v)) * steps;
            const double positive = std::floor(angle + 0.5) < 0.0 ? angle + turn : angle;
            order.emplace_back(std::lround(positive), !runs_forward(uses_[k]), k);  // ends before beginnings
        }
        std::sort(order.begin(), order.end());
        std::vector<std::size_t> begun;
        std::vector<bool> done(end - begin, false);
        for (int round = 0; round < 2; ++round)
            for (const auto& [angle, begins, k] : order) {
                if (done[k - begin]) continue;
                if (begins && round == 0) begun.push_back(k);
                if (begins || begun.empty()) continue;
                done[k - begin] = done[begun.back() - begin] = true;
                join(uses_[k], uses_[begun.back()]);
                begun.pop_back();
            }
    }

    void join(const EdgeUse& a, const EdgeUse& b) {
        const auto corner = [](const EdgeUse& use, bool low) {
            const int k = low == use.forward ? use.side : (use.side + 1) % 3;
            return 3 * use.triangle + static_cast<std::size_t>(k);
        };
        shells_.join(a.triangle, b.triangle);
        if (runs_forward(a) == runs_forward(b)) return;  // of a strip without sides
        for (const bool low : {true, false}) corners_.join(corner(a, low), corner(b, low));
        ++joined_[a.triangle];
        ++joined_[b.triangle];
    }

    std::vector<TriangleShell> collect() {
        std::map<std::size_t, std::vector<std::size_t>> members;
        for (std::size_t t = 0; t < soup_.triangles.size(); ++t) members[shells_.of(t)].push_back(t);
        std::vector<TriangleShell> found;
        for (const auto& [leader, list] : members) found.push_back(shell_of(list));
        return found;
    }

    TriangleShell shell_of(const std::vector<std::size_t>& members) {
        TriangleShell shell;
        std::map<std::size_t, int> numbers;
        shell.closed = members.size() >= 4;
        for (const std::size_t t : members) {
            Triangle triangle = soup_.triangles[t];
            for (std::size_t k = 0; k < 3; ++k) {
                const auto [place, is_new] =
                    numbers.try_emplace(corners_.of(3 * t + k), static_cast<int>(shell.vertices.size()));
                if (is_new) shell.vertices.push_back(at(triangle.corner[k]));
                triangle.corner[k] = place->second;
            }
            if (turned_[t]) std::swap(triangle.corner[1], triangle.corner[2]);
            shell.turned += turned_[t] ? 1 : 0;
            shell.closed = shell.closed && joined_[t] == 3;
            shell.one_sided = shell.one_sided || contradictory_[patches_.of(t)];
            shell.triangles.push_back(triangle);
        }
        shell.closed = shell.closed && !shell.one_sided;
        if (shell.closed) turn_outward(shell);
        return shell;
    }

    static void turn_outward(TriangleShell& shell) {
        constexpr double least = 1e-9;  // of what the area could enclose
        double volume = 0.0, area = 0.0;
        for (const Triangle& triangle : shell.triangles) {
            const Vec3 a = vector_area(shell.vertices, triangle);
            const Vec3 corner = shell.vertices[static_cast<std::size_t>(triangle.corner[0])] - shell.vertices[0];
            volume += glm::dot(corner, a) / 3.0;
            area += glm::length(a);
        }
        shell.closed = std::abs(volume) > least * area * std::sqrt(area);
        if (!shell.closed) return;
        shell.volume = std::abs(volume);
        if (volume > 0.0) return;
        for (Triangle& triangle : shell.triangles) std::swap(triangle.corner[1], triangle.corner[2]);
        shell.turned = shell.triangles.size() - shell.turned;
    }

    const TriangleSoup& soup_;
    std::vector<EdgeUse> uses_;
    Groups patches_, corners_, shells_;
    std::vector<bool> turned_, contradictory_;
    std::vector<int> joined_;  ///< edges of each triangle that have a neighbour
};

}  // namespace

std::vector<TriangleShell> shells_of(const TriangleSoup& soup) { return ShellFinder(soup).find(); }

double winding_number(const TriangleShell& shell, const Vec3& place) {
    double twice = 0.0;
    for (const Triangle& triangle : shell.triangles) {
        const auto corner = [&](std::size_t k) {
            return shell.vertices[static_cast<std::size_t>(triangle.corner[k])] - place;
        };
        const Vec3 a = corner(0), b = corner(1), c = corner(2);
        const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
        const double below = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
        twice += std::atan2(glm::dot(a, glm::cross(b, c)), below);  // half the solid angle
    }
    return twice / (2.0 * std::numbers::pi);
}

}  // namespace hanei
