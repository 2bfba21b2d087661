#pragma once

#include <string>
#include <vector>

namespace polhode::cli {

/// Takes the directory for this process until it ends, however it ends: flock(2) on the directory
/// itself, of which nothing is left behind. Where another process has it, says so in a line on
/// standard error and waits. Does nothing for a directory that this process has, and where the file
/// system has no such locks.
void lock_directory(const std::string& path);

/// The name under which a process writes a file before it gets its place.
[[nodiscard]] std::string temporary_name(const std::string& name, long process, int attempt);

/// Removes the temporary files that killed processes left in the directory: those of the names, or
/// all where `names` is empty. Files of processes that live stay.
void sweep_temporary_files(const std::string& directory, const std::vector<std::string>& names);

}  // namespace polhode::cli
