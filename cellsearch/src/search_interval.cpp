// SPDX-License-Identifier: BSD-3-Clause
#include "cellsearch/search_interval.hpp"

namespace cellsearch {

int search_interval(double expansion, double contact_distance, double largest_speed, double largest_step,
                    int cap) {
  const double room = expansion - contact_distance;
  // Written so that NaN anywhere ends in the careful answer.
  if (!(room > 0.0) || !(largest_speed >= 0.0) || !(largest_step >= 0.0) || cap <= 1) return 1;
  // Infinite for bodies at rest; compared before it is converted.
  const double steps = room / (largest_speed * largest_step);
  if (!(steps >= 1.0)) return 1;
  return steps >= static_cast<double>(cap) ? cap : static_cast<int>(steps);
}

}  // namespace cellsearch
