// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace crumple {

/// A file in memory, or why it cannot be.
struct InputFile {
  std::string text;
  std::string fault;  ///< empty if it was read, else half a sentence: "there is no such file"
};

/// Reads a regular file as a whole: the only way in which this program reads files, as names in decks and in
/// the results of others may lead anywhere. Devices, pipes, sockets, folders, files that the kernel makes up
/// (/proc), and those larger than `most_bytes` or than half of the machine's memory are refused, at once: a
/// pipe without a writer is not waited for. Links are followed.
InputFile read_input_file(const std::filesystem::path& path, std::uint64_t most_bytes = UINT64_MAX);

/// Half of the machine's memory.
std::uint64_t most_input_bytes();

/// The first bytes of a regular file, at most `most_bytes`; nothing where the above would refuse it.
std::string read_start(const std::filesystem::path& path, std::size_t most_bytes);

/// "12 bytes", "3.4 MB": for messages.
std::string size_text(std::uint64_t bytes);

}  // namespace crumple
