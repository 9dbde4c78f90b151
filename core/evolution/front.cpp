// SPDX-License-Identifier: MIT
#include "core/evolution/front.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace gaitsmith {

namespace {

/// The members in an order that depends on nothing but their aims and places.
template <class Before>
std::vector<std::size_t> Sorted(std::size_t count, Before before) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order,
                    [&](std::size_t a, std::size_t b) { return before(a, b) || (!before(b, a) && a < b); });
  return order;
}

}  // namespace

std::vector<int> FrontsOf(std::span<const Aims> aims) {
  const std::vector<std::size_t> order = Sorted(aims.size(), [&](std::size_t a, std::size_t b) {
    return aims[a].score != aims[b].score ? aims[a].score > aims[b].score : aims[a].thrift > aims[b].thrift;
  });
  std::vector<int> fronts(aims.size());
  // Of each front the last member, which has its most thrift. A later front never has more of it.
  std::vector<Aims> last;
  for (const std::size_t i : order) {
    const auto free =
        std::ranges::partition_point(last, [&](const Aims& a) { return Dominates(a, aims[i]); });
    fronts[i] = static_cast<int>(free - last.begin());
    if (free == last.end()) {
      last.push_back(aims[i]);
    } else {
      *free = aims[i];
    }
  }
  return fronts;
}

std::vector<double> CrowdingOf(std::span<const Aims> aims, std::span<const int> fronts) {
  std::vector<double> crowding(aims.size(), 0.0);
  // Along a front more score means less thrift, so one order serves both.
  const std::vector<std::size_t> order = Sorted(aims.size(), [&](std::size_t a, std::size_t b) {
    if (fronts[a] != fronts[b]) return fronts[a] < fronts[b];
    return aims[a].score < aims[b].score;
  });
  constexpr double kEnd = std::numeric_limits<double>::infinity();
  for (std::span<const std::size_t> rest = order; !rest.empty();) {
    std::size_t size = 0;
    while (size < rest.size() && fronts[rest[size]] == fronts[rest[0]]) ++size;
    const std::span<const std::size_t> front = rest.first(size);
    rest = rest.subspan(size);
    const auto gap = [&](std::size_t from, std::size_t to, float Aims::* aim) {
      const auto between = [&](std::size_t low, std::size_t high) {
        const double difference = static_cast<double>(aims[high].*aim) - static_cast<double>(aims[low].*aim);
        return difference < 0.0 ? -difference : difference;
      };
      const double extent = between(front.front(), front.back());
      return extent > 0.0 ? between(from, to) / extent : 0.0;
    };
    for (std::size_t i = 1; i + 1 < front.size(); ++i) {
      const std::size_t below = front[i - 1], above = front[i + 1];
      crowding[front[i]] = gap(below, above, &Aims::score) + gap(below, above, &Aims::thrift);
    }
    crowding[front.front()] = crowding[front.back()] = kEnd;
  }
  return crowding;
}

}  // namespace gaitsmith
