#pragma once

// One run on several processes: `mpirun -n 64 polhode map …`.
//
// All ranks run the same command. Rank 0 hands out the parts of the work, one at a time, to the
// rank that asks. It takes the results, and it alone reads and writes files and prints. The others
// are silent. One rank computes a part. A rank that dies takes the run with it, as is usual with
// MPI; what rank 0 has written by then stays.
//
// A part has a number. What the number means must follow from the arguments alone, and not from the
// machine: every rank decides it for itself.

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "cli/output/errors.hpp"

namespace polhode::cli::ranks {

/// Where a launcher of MPI (mpirun, srun --mpi) has started this program several times: joins the
/// others, and silences every rank but 0. Throws usage_error where the module for MPI is missing.
/// The arguments are those of the program: a rank that has others is found out by distribute.
void join(std::span<const char* const> arguments);

/// 1 where nothing was joined.
[[nodiscard]] int count();
/// A rank but 0.
[[nodiscard]] bool is_worker();

/// How many threads a rank uses that was told to use so many, 0 for as many as it may: one on
/// several ranks, else as many as there are processors (0).
[[nodiscard]] int threads(long given);

/// Calls keep(i, part(i)) for each i of rank 0's `parts`, in any order: part on any rank, rank 0
/// among them, and keep on rank 0 and its calling thread. Returns on rank 0 alone; the program ends
/// on the others. Throws what part or keep throws, and std::runtime_error where part threw on
/// another rank, or where that rank has other arguments or another version of the program.
void distribute(const std::vector<std::size_t>& parts,
                const std::function<std::string(std::size_t)>& part,
                const std::function<void(std::size_t, std::string)>& keep);

/// To be called last: waits for all ranks.
void leave();
/// To be called last after an error: rank 0 ends all ranks with the status; another rank tells
/// rank 0, and waits to be ended. Returns where nothing was joined.
void give_up(exit_status status) noexcept;

}  // namespace polhode::cli::ranks
