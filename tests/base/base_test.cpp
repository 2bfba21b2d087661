// The base room: digests, names that are near, texts in quotes, threads, clocks.

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "base/clock.hpp"
#include "base/nearest_name.hpp"
#include "base/quoted.hpp"
#include "base/sha256.hpp"
#include "base/worker_threads.hpp"

namespace polhode {
namespace base_test {

std::string hexadecimal_digest(std::string_view text) {
  std::string result;
  for (const std::uint8_t byte : sha256(std::as_bytes(std::span(text)))) {
    constexpr std::string_view digits = "0123456789abcdef";
    result += digits[byte / 16U];
    result += digits[byte % 16U];
  }
  return result;
}

// FIPS 180-2 (2002), appendix B; the empty text is of NIST's test vectors.
TEST(Sha256, AgreesWithTheExamplesOfTheStandard) {
  EXPECT_EQ(hexadecimal_digest(""),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(hexadecimal_digest("abc"),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(hexadecimal_digest("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(hexadecimal_digest(std::string(1'000'000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(NearestName, IsNearInCaseNeighboursAndLetters) {
  const std::vector<std::string> known{"ln", "sin", "digits", "time-limit"};
  EXPECT_EQ(near_name("Inf", known), std::nullopt);
  EXPECT_EQ(near_name("SIN", known), "sin");
  EXPECT_EQ(near_name("isn", known), "sin");
  EXPECT_EQ(near_name("nsi", known), std::nullopt);
  EXPECT_EQ(near_name("sinn", known), "sin");
  EXPECT_EQ(near_name("sinnn", known), std::nullopt);
  EXPECT_EQ(near_name("digts", known), "digits");
  EXPECT_EQ(near_name("time-limt", known), "time-limit");
  EXPECT_EQ(near_name("", known), std::nullopt);
  EXPECT_EQ(near_name("sin", {}), std::nullopt);
}

TEST(NearestName, IsTheFirstOfTheNearest) {
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(nearest_name("cat", {"dog", "cut", "cot"}), "cut");
}

TEST(Quoted, IsOneLineAndNotLong) {
  EXPECT_EQ(detail::quoted("x^2"), "\"x^2\"");
  EXPECT_EQ(detail::quoted("a\nb\tc\x7f"), "\"a?b?c?\"");
  EXPECT_EQ(detail::quoted(std::string(60, 'x')), '"' + std::string(60, 'x') + '"');
  EXPECT_EQ(detail::quoted(std::string(61, 'x')),
            '"' + std::string(60, 'x') + "...\" (61 characters)");
}

TEST(WorkerThreads, TakeEachStepOnce) {
  for (const int threads : {0, 1, 2, 5}) {
    detail::worker_threads workers(threads);
    EXPECT_GE(workers.count(), 1);
    EXPECT_LE(workers.count(), detail::worker_threads::processors());
    std::array<std::atomic<int>, 100> calls{};
    workers.for_each(100, [&](long i) { ++calls[static_cast<std::size_t>(i)]; });
    for (const auto& count : calls) EXPECT_EQ(count, 1);
  }
}

TEST(WorkerThreads, RethrowWhatAStepThrows) {
  detail::worker_threads workers(2);
  EXPECT_THROW(workers.for_each(100,
                                [](long i) {
                                  if (i == 37) throw std::runtime_error("37");
                                }),
               std::runtime_error);
}

TEST(Clock, CountsSeconds) {
  const auto minute_ago = detail::clock::now() - std::chrono::minutes(1);
  EXPECT_GE(detail::seconds_since(minute_ago), 60);
  const double before = detail::processor_seconds();
  EXPECT_GE(detail::processor_seconds(), before);
}

}  // namespace base_test
}  // namespace polhode
