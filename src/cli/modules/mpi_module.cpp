// Messages by MPI. The program loads this module where mpirun started it, and does without MPI
// elsewhere.

#include <climits>
#include <cstdlib>
#include <stdexcept>

// The bindings for C alone.
#define OMPI_SKIP_MPICXX
#define MPICH_SKIP_MPICXX
#include <mpi.h>

#include "cli/modules/message_passing.hpp"

namespace polhode::cli {
namespace {

class mpi_messages : public message_passing {
 public:
  mpi_messages() {
    int provided = 0;
    // On an error MPI ends all ranks, as its default is.
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    if (provided < MPI_THREAD_FUNNELED) abort(2);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
  }
  ~mpi_messages() override { MPI_Finalize(); }
  mpi_messages(const mpi_messages&) = delete;
  mpi_messages& operator=(const mpi_messages&) = delete;
  mpi_messages(mpi_messages&&) = delete;
  mpi_messages& operator=(mpi_messages&&) = delete;

  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int size() const override { return size_; }
  void send(int to, const std::string& bytes) override {
    if (bytes.size() > INT_MAX) throw std::length_error("a message of more than 2 GB");
    MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_CHAR, to, tag, MPI_COMM_WORLD);
  }
  [[nodiscard]] std::optional<message> receive() override {
    int arrived = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, tag, MPI_COMM_WORLD, &arrived, &status);
    if (arrived == 0) return std::nullopt;
    int size = 0;
    MPI_Get_count(&status, MPI_CHAR, &size);
    message result{status.MPI_SOURCE, std::string(static_cast<std::size_t>(size), '\0')};
    MPI_Recv(result.bytes.data(), size, MPI_CHAR, result.from, tag, MPI_COMM_WORLD,
             MPI_STATUS_IGNORE);
    return result;
  }
  [[noreturn]] void abort(int status) noexcept override {
    MPI_Abort(MPI_COMM_WORLD, status);
    std::abort();
  }

 private:
  static constexpr int tag = 0;
  int rank_ = 0;
  int size_ = 1;
};

}  // namespace
}  // namespace polhode::cli

/// Joins the ranks; ranks.cpp calls it by this name. The caller owns the result.
extern "C" polhode::cli::message_passing* polhode_message_passing() {
  return new polhode::cli::mpi_messages;
}
