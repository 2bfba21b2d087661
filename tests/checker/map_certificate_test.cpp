// Certificates of maps: what is true is shown again, and a cell, a cut or an area that is not right
// is refused where it stands.

#include <gtest/gtest.h>

#include "maps.hpp"
#include "polhode/checker/check.hpp"

namespace polhode::checker {
namespace map_certificate_test {

using test::map_json;

report checked(json certificate) {
  test::make_digest_right(certificate);
  return check(certificate.dump());
}

/// With the text of one part of a cell in place of what is there.
json with_part(std::size_t cell, std::size_t part, const char* text) {
  json changed = map_json();
  changed["witness"]["cells"][cell][part] = text;
  return changed;
}

void expect_refused(const json& certificate, const std::string& place, const std::string& message) {
  const report r = checked(certificate);
  EXPECT_NE(r.result, outcome::verified) << place;
  EXPECT_EQ(r.place.rfind(place, 0), 0U) << r.place << ": " << r.message;
  EXPECT_NE(r.message.find(message), std::string::npos) << r.message;
}

TEST(MapCertificate, IsShownAgain) {
  const report r = checked(map_json());
  EXPECT_EQ(r.result, outcome::verified) << r.place << ": " << r.message;
  EXPECT_EQ(r.subject, "map of intersections physical");
  EXPECT_EQ(r.checks.size(), 2U);
}

TEST(MapCertificate, AValueMustBeThatOfBothCorners) {
  // N is 0 at the least and 1 at the greatest corner of the first cell: neither is its value.
  expect_refused(with_part(0, 0, "0 1"), "/witness/cells/0/0",
                 "intersections is 1 for the body a = 2, b = 1/5 of the cell");
  expect_refused(with_part(0, 0, "1 1"), "/witness/cells/0/0",
                 "intersections is 0 for the body a = 1, b = 1/10 of the cell");
  expect_refused(with_part(2, 0, "1 1"), "/witness/cells/2/0", "physical is 0 for the body a = 4");
  expect_refused(with_part(2, 0, "1 0"), "/witness/cells/2/0", "physical is 1 for the body a = 2");
}

TEST(MapCertificate, PartsMustBeTheWholeCell) {
  json fewer = map_json();
  fewer["witness"]["cells"][1].erase(2);
  expect_refused(fewer, "/witness/cells/1", "its parts are not the whole cell");
  json more = map_json();
  more["witness"]["cells"][1].push_back("? ?");
  expect_refused(more, "/witness/cells/1/3", "the parts before it are the whole cell");
  for (const char* outside : {"b 1/5", "b 1/2", "b 1/10", "b 3", "a 1", "a -1"}) {
    expect_refused(with_part(1, 0, outside), "/witness/cells/1/0",
                   "the cut is not inside the cell");
  }
  json none = map_json();
  none["witness"]["cells"][2] = json::array();
  expect_refused(none, "/witness/cells/2", "its parts are not the whole cell");
  none["witness"]["cells"].erase(2);
  expect_refused(none, "/witness/cells", "a list for each cell");
}

TEST(MapCertificate, TheGridMustBeTheRectangle) {
  for (const char* axis : {"a", "b"}) {
    json shorter = map_json();
    shorter["witness"][axis][2] = std::string(axis) == "a" ? "3" : "2/5";
    expect_refused(shorter, std::string("/witness/") + axis + "/2", "where the rectangle ends");
    json later = map_json();
    later["witness"][axis][0] = std::string(axis) == "a" ? "3/2" : "3/20";
    expect_refused(later, std::string("/witness/") + axis + "/0", "where the rectangle begins");
    json backwards = map_json();
    std::swap(backwards["witness"][axis][1], backwards["witness"][axis][2]);
    expect_refused(backwards, std::string("/witness/") + axis + "/2", "not above the one before");
  }
}

/// A certificate whose rectangle has other ends, in all places where they stand.
json with_end(const char* input, std::size_t k, const char* text) {
  json c = map_json();
  c["inputs"][input] = text;
  c["witness"][std::string(1, input[0])][k] = text;
  const json& i = c["inputs"];
  c["statement"] = statements::fill(statements::map_statement,
                                    {i["a_from"].get<std::string>(), i["a_to"].get<std::string>(),
                                     i["b_from"].get<std::string>(), i["b_to"].get<std::string>()});
  return c;
}

TEST(MapCertificate, IsOfBodiesAlone) {
  expect_refused(with_end("a_from", 0, "0"), "/inputs/a_from", "above 0");
  expect_refused(with_end("b_from", 0, "-1/10"), "/inputs/b_from", "above 0");
  expect_refused(with_end("b_to", 2, "1"), "/inputs/b_to", "below 1");
}

TEST(MapCertificate, AreasMustBeRight) {
  const auto with_share = [](const char* share) {
    json c = map_json();
    c["facts"][0]["statement"] =
        statements::fill(statements::map_fact, {"intersections", "4", "6", share, ""});
    return c;
  };
  EXPECT_EQ(checked(with_share("79.18")).result, outcome::verified);  // not the least, but right
  expect_refused(with_share("79.16"), "/facts/0/statement", "the area is greater");
  expect_refused(with_share("79.19"), "/facts/0/statement", "the area is smaller");
  expect_refused(with_share("80"), "/facts/0/statement", "two decimals");
  expect_refused(with_share("-1.00"), "/facts/0/statement", "the area is greater");
  json fewer = map_json();
  fewer["facts"][0]["statement"] =
      statements::fill(statements::map_fact, {"intersections", "3", "6", "79.17", ""});
  EXPECT_EQ(checked(fewer).place, "/facts/0/statement");
}

TEST(MapCertificate, QuantitiesAreThoseThatAreKnown) {
  json other = map_json();
  other["inputs"]["quantities"] = "intersections phase";
  expect_refused(other, "/inputs/quantities", "which is no quantity");
  other["inputs"]["quantities"] = "physical physical";
  expect_refused(other, "/inputs/quantities", "twice");
  other["inputs"]["quantities"] = "";
  expect_refused(other, "/inputs/quantities", "which is no quantity");
  expect_refused(with_part(0, 0, "1"), "/witness/cells/0/0", "for each of 2 quantities");
  expect_refused(with_part(0, 0, "? 1 "), "/witness/cells/0/0", "for each of 2 quantities");
}

TEST(MapCertificate, WorkIsLimited) {
  json c = map_json();
  limits few;
  few.work = 20'000;
  test::make_digest_right(c);
  EXPECT_EQ(check(c.dump(), few).result, outcome::not_checkable);
}

}  // namespace map_certificate_test
}  // namespace polhode::checker
