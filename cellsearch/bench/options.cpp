// SPDX-License-Identifier: BSD-3-Clause
#include "options.hpp"

#include <cmath>
#include <cstdlib>
#include <utility>

namespace cellsearch::bench {
namespace {

std::vector<std::string> split(const std::string& option, const std::string& list) {
  std::vector<std::string> items;
  std::size_t begin = 0;
  while (begin <= list.size()) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    if (end == begin) {
      throw UsageError("The list \"" + list + "\" of " + option + " has an empty entry.");
    }
    items.push_back(list.substr(begin, end - begin));
    begin = end + 1;
  }
  return items;
}

double parse_number(const std::string& option, const std::string& text, double least, double most) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !(value >= least && value <= most)) {
    const auto brief = [](double x) { return std::to_string(std::llround(x)); };
    throw UsageError(option + " takes numbers from " + brief(least) + " to " + brief(most) + ", not \"" +
                     text + "\".");
  }
  return value;
}

int parse_whole(const std::string& option, const std::string& text, double most) {
  const double value = parse_number(option, text, 1.0, most);
  if (value != std::floor(value)) throw UsageError(option + " takes whole numbers, not \"" + text + "\".");
  return static_cast<int>(value);
}

std::vector<int> parse_list(const std::string& option, const std::string& text, double most) {
  std::vector<int> values;
  for (const std::string& item : split(option, text)) values.push_back(parse_whole(option, item, most));
  return values;
}

void set_option(Options& options, const std::string& name, const std::string& value) {
  if (name == "--scenes") {
    options.scenes = parse_list(name, value, 1000.0);
  } else if (name == "--nodes") {
    options.nodes = parse_list(name, value, 2e8);
  } else if (name == "--methods") {
    options.methods = split(name, value);
  } else if (name == "--threads") {
    options.threads = parse_list(name, value, 1024.0);
  } else if (name == "--repeats") {
    options.repeats = parse_whole(name, value, 1e6);
  } else if (name == "--seconds") {
    options.seconds = parse_number(name, value, 0.0, 1e6);
  } else if (name == "--csv") {
    options.csv = value;
  } else if (name == "--plots") {
    options.plots = value;
  } else if (name == "--order" && (value == "natural" || value == "shuffled")) {
    options.shuffled = value == "shuffled";
  } else if (name == "--order") {
    throw UsageError("--order is natural or shuffled, not \"" + value + "\".");
  } else {
    throw UsageError("There is no option " + name + "; see --help.");
  }
}

}  // namespace

Options parse_options(const std::vector<std::string>& arguments) {
  Options options;
  for (std::size_t k = 0; k < arguments.size(); ++k) {
    const std::string& name = arguments[k];
    if (name == "--help" || name == "-h") {
      options.help = true;
    } else if (name == "--list") {
      options.list = true;
    } else {
      if (name.rfind("--", 0) != 0) throw UsageError("\"" + name + "\" is no option; see --help.");
      const std::size_t equals = name.find('=');
      if (equals != std::string::npos) {
        const std::string value = name.substr(equals + 1);
        set_option(options, name.substr(0, equals), value);
      } else if (k + 1 < arguments.size()) {
        set_option(options, name, arguments[++k]);
      } else {
        set_option(options, name, "");
      }
    }
  }
  return options;
}

std::string help_text() {
  return R"(cellsearch-bench measures contact searches: the methods of this library and, where they were
installed when it was built, other libraries that answer the same exact question.

Usage: cellsearch-bench [options]

  --scenes 1,2,...      scenes to measure (default: all; see --list)
  --nodes N,N,...       number of nodes of each scene, as 100000 or 1e5 (default: 1e4,1e5)
  --methods a,b,...     methods to measure: names from --list, or all, own, peers (default: all)
  --threads T,T,...     numbers of threads (default: 1); methods that know only one run with one only
  --order ORDER         numbering of nodes and segments: natural (default) or shuffled
  --repeats R           measurements of each method, of which the median counts (default: 5; scenes below
                        100 000 nodes are measured up to 10 times as often, unless R is 1)
  --seconds S           a method that has used S seconds on a scene is not repeated again (default: 20)
  --csv FILE            write scene,nodes,segments,method,threads,build_ns,query_ns,bytes_per_node,pairs,hash
                        (times in ns per segment)
  --plots FOLDER        draw scene<k>.svg: time per segment and memory per node over the number of nodes
  --list                list scenes and methods, say which peers are missing, and end
  --help                this text

All methods of a scene run in turns in this one process. Each is run twice before it is measured: memory is
the most that it holds during the second search, less the answer. All must give the same pairs.

Examples:
  cellsearch-bench --scenes 1,2,3 --nodes 1e6
  cellsearch-bench --scenes 4 --methods linked-cell,production --nodes 1e4,1e5,1e6,1e7 --plots plots
  OMP_PROC_BIND=true cellsearch-bench --methods own --threads 1,2 --csv own.csv

Exit code: 0 if all is well, 1 if methods differ or a file cannot be written, 2 if the options are wrong.
)";
}

}  // namespace cellsearch::bench
