// SPDX-License-Identifier: BSD-3-Clause
#include "output/results/history_sample.hpp"

#include <stdexcept>

namespace crumple::output {

Sample::Sample(std::span<const Variable> variables) : variables_(variables), values_(variables.size()) {}

void Sample::start(double time, long cycle) {
  time_ = time;
  cycle_ = cycle;
  for (std::vector<double>& values : values_) values.clear();
}

void Sample::add_item(std::initializer_list<double> values, std::size_t first) {
  std::size_t variable = first;
  for (const double value : values) values_[variable++].push_back(value);
}

std::size_t Sample::place_of(std::string_view name) const {
  for (std::size_t i = 0; i < variables_.size(); ++i)
    if (variables_[i].name == name) return i;
  throw std::logic_error("a history has no variable " + std::string(name));
}

std::vector<double>& Sample::of(std::string_view name) {
  return values_[place_of(name)];
}

const std::vector<double>& Sample::of(std::string_view name) const {
  return values_[place_of(name)];
}

}  // namespace crumple::output
