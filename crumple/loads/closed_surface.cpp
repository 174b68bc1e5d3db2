// SPDX-License-Identifier: BSD-3-Clause
#include "loads/closed_surface.hpp"

#include <algorithm>

#include "base/parallel.hpp"

namespace crumple::loads {

using math::Vec3;

namespace {

constexpr Index surface_piece = 1024;

}  // namespace

// Of a quadrilateral x(xi, eta) = a + b xi + c eta + d xi eta the normal is
//     dx/dxi x dx/deta = b x c + xi b x d + eta d x c,
// and the corner's function 1/4 (1 + xi_k xi) (1 + eta_k eta) has the moments 1, xi_k / 3 and eta_k / 3.
std::array<Vec3, 4> corner_areas(const std::array<Vec3, 4>& x, bool is_triangle) {
  if (is_triangle) {
    const Vec3 third = (1.0 / 6) * cross(x[1] - x[0], x[2] - x[0]);
    return {third, third, third, Vec3{}};
  }
  constexpr double xi[4] = {-1, 1, 1, -1};
  constexpr double eta[4] = {-1, -1, 1, 1};
  const Vec3 b = 0.25 * ((x[1] - x[0]) + (x[2] - x[3]));
  const Vec3 c = 0.25 * ((x[2] - x[1]) + (x[3] - x[0]));
  const Vec3 d = 0.25 * ((x[0] - x[1]) + (x[2] - x[3]));
  const Vec3 mean = cross(b, c);
  const Vec3 along_xi = (1.0 / 3) * cross(b, d);
  const Vec3 along_eta = (1.0 / 3) * cross(d, c);
  std::array<Vec3, 4> areas;
  for (std::size_t k = 0; k < 4; ++k) areas[k] = mean + xi[k] * along_xi + eta[k] * along_eta;
  return areas;
}

ClosedSurface::ClosedSurface(const std::vector<std::array<Index, 4>>& segments) : segments_(segments) {
  for (const std::array<Index, 4>& segment : segments_)
    nodes_.insert(nodes_.end(), segment.begin(), segment.end());
  std::sort(nodes_.begin(), nodes_.end());
  nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
  std::vector<std::vector<Index>> corners(nodes_.size());
  for (std::size_t s = 0; s < segments_.size(); ++s)
    for (std::size_t k = 0; k < (segments_[s][2] == segments_[s][3] ? 3U : 4U); ++k) {
      const auto node = std::lower_bound(nodes_.begin(), nodes_.end(), segments_[s][k]);
      corners[static_cast<std::size_t>(node - nodes_.begin())].push_back(static_cast<Index>(4 * s + k));
    }
  first_corner_.push_back(0);
  for (const std::vector<Index>& of_node : corners) {
    corners_.insert(corners_.end(), of_node.begin(), of_node.end());
    first_corner_.push_back(static_cast<Index>(corners_.size()));
  }
  parts_.resize(segments_.size());
  gradients_.resize(nodes_.size());
  sums_.resize(static_cast<std::size_t>(pieces(static_cast<Index>(segments_.size()), surface_piece)));
}

void ClosedSurface::measure(const domain::NodeFields& fields, int threads) {
  const auto segments = static_cast<Index>(segments_.size());
  const auto nodes = static_cast<Index>(nodes_.size());
  // Seen from one of its nodes: far away from the origin digits would be lost.
  const Vec3 origin = nodes_.empty() ? Vec3{} : fields.position[nodes_.front()];
  parallel_for(pieces(segments, surface_piece), threads, [&](Index p) {
    std::array<double, 2> sum{};
    for (Index s = p * surface_piece; s < std::min((p + 1) * surface_piece, segments); ++s) {
      const std::array<Index, 4>& segment = segments_[static_cast<std::size_t>(s)];
      std::array<Vec3, 4> x;
      for (std::size_t k = 0; k < 4; ++k) x[k] = fields.position[segment[k]] - origin;
      const std::array<Vec3, 4> areas = corner_areas(x, segment[2] == segment[3]);
      parts_[static_cast<std::size_t>(s)] = areas;
      // Three times the volume of the cone from the origin is the integral of x.n, and x is linear in the
      // corners.
      sum[0] += (dot(x[0], areas[0]) + dot(x[1], areas[1])) + (dot(x[2], areas[2]) + dot(x[3], areas[3]));
      sum[1] += norm((areas[0] + areas[1]) + (areas[2] + areas[3]));
    }
    sums_[static_cast<std::size_t>(p)] = sum;
  });
  volume_ = area_ = 0;
  for (const std::array<double, 2>& sum : sums_) {
    volume_ += sum[0] / 3;
    area_ += sum[1];
  }
  parallel_for(pieces(nodes, surface_piece), threads, [&](Index p) {
    for (Index i = p * surface_piece; i < std::min((p + 1) * surface_piece, nodes); ++i) {
      const auto at = static_cast<std::size_t>(i);
      Vec3 sum;
      for (Index c = first_corner_[at]; c < first_corner_[at + 1]; ++c) {
        const Index corner = corners_[static_cast<std::size_t>(c)];
        sum += parts_[static_cast<std::size_t>(corner / 4)][static_cast<std::size_t>(corner % 4)];
      }
      gradients_[at] = sum;
    }
  });
}

double present_area(const std::vector<std::array<Index, 4>>& segments, const domain::NodeFields& fields,
                    int threads) {
  const auto count = static_cast<Index>(segments.size());
  std::vector<double> sums(static_cast<std::size_t>(pieces(count, surface_piece)));
  parallel_for(pieces(count, surface_piece), threads, [&](Index p) {
    double sum = 0;
    for (Index s = p * surface_piece; s < std::min((p + 1) * surface_piece, count); ++s) {
      const std::array<Index, 4>& node = segments[static_cast<std::size_t>(s)];
      const auto x = [&](std::size_t k) { return fields.position[node[k]]; };
      // Half the cross product of the diagonals; of a triangle, which repeats its third node, of two sides.
      sum += 0.5 * norm(cross(x(2) - x(0), x(3) - x(1)));
    }
    sums[static_cast<std::size_t>(p)] = sum;
  });
  double area = 0;
  for (const double sum : sums) area += sum;
  return area;
}

}  // namespace crumple::loads
