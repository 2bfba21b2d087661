// A certificate in which one thing was changed, its digest made right again, is refused and the
// place is named; or it is still true, and the list below says why.

#include <array>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <boost/regex.hpp>  // std::regex draws warnings under the sanitizers

#include "formulas.hpp"
#include "maps.hpp"
#include "polhode/checker/check.hpp"
#include "proofs/claim.hpp"
#include "support/random.hpp"

namespace polhode::checker {
namespace mutation_test {

using test::make_digest_right;
using pointer = json::json_pointer;

/// Where a change may leave a certificate true, and why.
struct harmless {
  const char* claims;
  const char* place;
  const char* why;
};
constexpr std::array harmless_changes{
    harmless{".*", "/software/[a-z]+", "versions take no part in a proof"},
    harmless{".*", "/numbers/[^/]+/(lower|upper)",
             "a decimal that is wider, outward, by a unit or two of its last place"},
    harmless{".*", "/.*/radius", "a radius that is wider, by less than twice"},
    harmless{"beta|sign_dF_du|integral|roots", "/.*/(value|digits)",
             "a rounded value that is as near as its radius says, or fewer of its digits"},
    harmless{".*", "/numbers/[^/]+/dyadic/(lower|upper)/(mantissa|exponent)",
             "another enclosure that the checker finds to hold the number as well"},
    harmless{"first_equation", "/inputs/[ab]",
             "another body: the proof is for all, and nothing else is said of the one given"},
    harmless{"limit_minimum|epsilon0_decreases|c0_decreases|count|intersection|perfect_twist",
             "/witness/[a-z0-9_]+(/0)?/(lower|upper)",
             "another bracket of the same root, with the same decimals"},
    harmless{"injectivity", "/witness/chain/[0-9]+/(lower|upper)",
             "another enclosure of epsilon(c), apart from its neighbours"},
    harmless{"beta", "/witness/(below|above)/(start|steps/[0-9]+)/[01]",
             "a pair that is rounded further outward, and still decides"},
    harmless{"beta", "/witness/(below|above)/steps(/[0-9]+)?",
             "more or fewer steps, each rounded outward, that still decide"},
    harmless{"beta", "/witness/newton/(box|image)/(lower|upper)/mantissa",
             "a box that still holds the image, or an image that still holds the root"},
    harmless{"beta", "/witness/newton/derivative/(lower|upper)", "a wider decimal, outward"},
    harmless{"beta|sign_dF_du",
             "/witness/quadrature(/below|/above)?/(half_width|supremum|truncation_error)",
             "another strip, or bounds rounded further up"},
    harmless{"beta|sign_dF_du",
             "/witness/quadrature(/below/integral|/above/integral|/value)/(lower|upper)",
             "a wider decimal, outward"},
    harmless{"epsilon0_min|delta_psi_max", "/witness/second_route/(lower|upper)",
             "a wider decimal, outward"},
    harmless{"integral|roots|system", "/numbers/[^/]+/digits_asked",
             "what was asked for: the digits that are there are checked"},
    harmless{"integral", "/witness/pieces/[0-9]+/(rho|supremum|nodes)",
             "another ellipse, another bound or more nodes, with which it is shown as well"},
    harmless{"integral", "/witness/pieces/[0-9]+/end",
             "other pieces of the same range, with which it is shown as well"},
    harmless{"roots", "/witness/boxes/[0-9]+/(lower|upper)",
             "another box around the same root, on which the derivative is not 0 either"},
    harmless{"system", "/witness/boxes/[0-9]+/[0-9]+/(lower|upper)",
             "another box around the same root, on which the derivatives are regular too"},
    harmless{
        "map", "/witness/cells/[0-9]+/[0-9]+",
        "another cut, by which as many cells are decided, on about the same share of the area"},
    harmless{"map", "/facts/[0-9]+/statement",
             "a share of the area that is greater than it must be, by less than 0.02"},
};

std::string reason_for(const std::string& claim, const std::string& place) {
  for (const harmless& h : harmless_changes) {
    if (boost::regex_match(claim, boost::regex(h.claims)) &&
        boost::regex_match(place, boost::regex(h.place))) {
      return h.why;
    }
  }
  return "";
}

void collect(const json& value, const pointer& at, std::vector<pointer>& all) {
  all.push_back(at);
  if (value.is_object()) {
    for (const auto& [key, member] : value.items()) collect(member, at / key, all);
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) collect(value[i], at / i, all);
  }
}

class mutations {
 public:
  explicit mutations(json certificate) : good_(std::move(certificate)) {}

  /// Everything that is changed at one place.
  std::vector<std::pair<std::string, json>> at(const pointer& where, std::mt19937_64& engine) {
    std::vector<std::pair<std::string, json>> result;
    const json& value = good_.at(where);
    const auto put = [&](const std::string& what, const json& other) {
      json changed = good_;
      changed[where] = other;
      result.emplace_back(what, std::move(changed));
    };
    if (value.is_string()) {
      change_text(value.get<std::string>(), engine, put);
    } else if (value.is_boolean()) {
      put("the opposite", !value.get<bool>());
    } else if (value.is_number_integer()) {
      for (const long step : {-10L, -1L, 1L, 10L}) {
        put(fmt::format("{:+}", step), value.get<long>() + step);
      }
    } else if (value.is_array() && !value.empty()) {
      json other = value;
      other.push_back(value.back());
      put("its last element twice", other);
      other = value;
      other.erase(other.size() - 1);
      put("without its last element", other);
      other = value;
      other.erase(0);
      put("without its first element", other);
    } else if (value.is_object() && !value.empty()) {
      for (const auto& [key, member] : value.items()) {
        json other = value;
        other.erase(key);
        put("without " + key, other);
      }
      json other = value;
      other["another"] = "key";
      put("with another key", other);
    }
    return result;
  }

 private:
  template <class Put>
  void change_text(const std::string& text, std::mt19937_64& engine, const Put& put) {
    std::set<std::size_t> positions;
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] >= '0' && text[i] <= '9') positions.insert(i);
    }
    // Of many digits the first, the last, and some.
    if (positions.size() > 6) {
      std::vector<std::size_t> all(positions.begin(), positions.end());
      positions = {all.front(), all[all.size() - 2], all.back()};
      positions.insert(all[std::uniform_int_distribution<std::size_t>(0, all.size() - 1)(engine)]);
    }
    for (const std::size_t i : positions) {
      for (const int step : {1, 9}) {
        std::string other = text;
        other[i] = static_cast<char>('0' + (text[i] - '0' + step) % 10);
        put(fmt::format("digit {} as {}", i, other[i]), other);
      }
    }
    put("another letter", text + "x");
    put("nothing", "");
    if (!positions.empty()) put("the opposite", text.front() == '-' ? text.substr(1) : '-' + text);
  }

  json good_;
};

struct count {
  int refused = 0;
  int harmless = 0;
};

/// Changes a share of the places of a certificate.
count mutate(json good, double share) {
  const std::string claim = good["claim"];
  good["software"] = {{"polhode", "1"}, {"mpfr", "2"}, {"gmp", "3"}, {"boost", "4"}};
  make_digest_right(good);
  EXPECT_EQ(check(good.dump()).result, outcome::verified) << claim;
  std::vector<pointer> places;
  collect(good, pointer(), places);
  std::mt19937_64 engine(8);
  std::uniform_real_distribution<double> chance;
  mutations of(good);
  count result;
  for (const pointer& where : places) {
    if (chance(engine) > share) continue;
    for (auto& [what, changed] : of.at(where, engine)) {
      if (where.to_string() != "/digest" && changed.contains("digest")) make_digest_right(changed);
      if (changed == good) continue;
      const report r = check(changed.dump());
      const std::string place = where.to_string();
      if (r.result != outcome::verified) {
        ++result.refused;
        EXPECT_FALSE(r.message.empty()) << claim << place << what;
        EXPECT_TRUE(!r.place.empty() || place.empty()) << claim << place << what;
        if (place.empty() || place == "/digest") continue;
        EXPECT_NE(r.place, "/digest") << claim << ": " << place << ": " << what
                                      << ": only the digest tells it from a good one";
        continue;
      }
      ++result.harmless;
      EXPECT_NE(reason_for(claim, place), "")
          << claim << ": " << place << ": " << what << ": it is accepted, and nothing says why";
    }
  }
  return result;
}

class EveryClaim : public testing::TestWithParam<std::string> {};

TEST_P(EveryClaim, NoChangeOfAnyPlaceIsAccepted) {
  // Those that take longest to check have fewer places changed.
  const std::map<std::string, double> shares{{"injectivity", 0.005}, {"sign_dF_du", 0.02}};
  const auto found = shares.find(GetParam());
  const double share = found == shares.end() ? 0.25 : found->second;
  proofs::request wanted;
  wanted.digits = 20;
  const count c = mutate(to_json(proofs::find_claim(GetParam())->prove(wanted)),
                         std::min(1.0, share * support::effort()));
  if (support::effort() >= 1) {  // with less, few places are changed, or none
    EXPECT_GT(c.refused, 2);
  }
}

INSTANTIATE_TEST_SUITE_P(Mutation, EveryClaim, testing::ValuesIn([] {
                           std::vector<std::string> names;
                           for (const auto& c : proofs::all_claims()) names.emplace_back(c.name);
                           return names;
                         }()),
                         [](const auto& instance) { return instance.param; });

TEST(Mutation, NoChangeOfAFormulasCertificateIsAccepted) {
  for (const json& good :
       {test::integral_json("4/(1+x^2)", "0", "1", "pi"),
        test::integral_json("1/(1+100*x^2)", "-1", "pi", "(atan(10)+atan(10*pi))/10"),
        test::roots_json("sin(x) - x/10", "1", "4", {"2.852341894450091648325219940703"}, 17),
        test::roots_json("(x^2-2)*(x-1/2)", "-pi", "2", {"-sqrt(2)", "1/2", "sqrt(2)"}),
        test::system_json({"x^2+y^2-1", "x-y^3"}, {{"x", "-2", "2"}, {"y", "-2", "2"}})}) {
    const count c = mutate(good, std::min(1.0, support::effort()));
    if (support::effort() >= 1) {
      EXPECT_GT(c.refused, 100);
      EXPECT_GT(c.harmless, 0);
    }
  }
}

TEST(Mutation, NoChangeOfAMapIsAccepted) {
  const count c = mutate(test::map_json(), std::min(1.0, support::effort()));
  if (support::effort() >= 1) {
    EXPECT_GT(c.refused, 100);
  }
}

TEST(Mutation, ADigestAloneIsRefused) {
  json c = to_json(proofs::find_claim("physical")->prove({}));
  c["software"]["gmp"] = "9.9.9";
  const report r = check(c.dump());
  EXPECT_EQ(r.result, outcome::refuted);
  EXPECT_EQ(r.place, "/digest");
}

/// Wrong digits in every form in which a number is written, with a right digest.
TEST(Mutation, WrongDigitsThatAgreeAreRefusedByMathematics) {
  json c = to_json(proofs::find_claim("delta_psi_max")->prove({}));
  json& x = c["numbers"]["delta_psi_max"];
  const std::string text = x["value"];
  const auto replaced = [](std::string s) {
    char& digit = s.at(20);
    digit = digit == '5' ? '6' : '5';
    return s;
  };
  const rational step = parse_rational(replaced(text)) - parse_rational(text);
  for (const char* end : {"lower", "upper"}) x[end] = replaced(x[end]);  // the radius is the same
  x["value"] = replaced(text);
  // The exact ends moved by as much, to 2^-400.
  for (const char* end : {"lower", "upper"}) {
    const json& d = x["dyadic"][end];
    const auto exponent = d["exponent"].get<long>();
    const rational moved = parse_rational(d["mantissa"].get<std::string>()) +
                           step * rational(integer(1) << static_cast<unsigned>(-exponent));
    integer mantissa = numerator(moved) / denominator(moved) + (end[0] == 'l' ? 0 : 1);
    long e = exponent;
    while (mantissa % 2 == 0) {
      mantissa /= 2;
      ++e;
    }
    x["dyadic"][end] = json{{"mantissa", mantissa.str()}, {"exponent", e}};
  }
  make_digest_right(c);
  const report r = check(c.dump());
  EXPECT_EQ(r.result, outcome::refuted);
  EXPECT_EQ(r.place, "/numbers/delta_psi_max/dyadic") << r.message;
}

/// An angle that is off by pi has the same sine squared.
TEST(Mutation, AMirrorImageOfARootIsRefused) {
  proofs::request wanted;
  wanted.digits = 5;
  json c = to_json(proofs::find_claim("separatrix_twist")->prove(wanted));
  // epsilon0 + pi = 3.25518703593122...
  c["numbers"]["epsilon0"] =
      json{{"value", "3.2551"},    {"radius", "0.000088"}, {"lower", "3.255187"},
           {"upper", "3.2551872"}, {"digits", 5},          {"digits_asked", 5}};
  const auto dyadic = [](const char* text, bool up) {
    const rational scaled = parse_rational(text) * rational(integer(1) << 40U);
    integer mantissa = numerator(scaled) / denominator(scaled) + (up ? 1 : 0);
    long exponent = -40;
    for (; mantissa % 2 == 0; ++exponent) mantissa /= 2;
    return json{{"mantissa", mantissa.str()}, {"exponent", exponent}};
  };
  c["numbers"]["epsilon0"]["dyadic"] =
      json{{"lower", dyadic("3.2551870359", false)}, {"upper", dyadic("3.2551870360", true)}};
  make_digest_right(c);
  const report r = check(c.dump());
  EXPECT_EQ(r.result, outcome::refuted);
  EXPECT_EQ(r.place, "/numbers/epsilon0/dyadic/lower") << r.message;
}

TEST(Mutation, AnInputTooManyIsRefused) {
  json c = to_json(proofs::find_claim("physical")->prove({}));
  c["inputs"]["u"] = "1/4";
  make_digest_right(c);
  EXPECT_EQ(check(c.dump()).place, "/inputs/u");
}

}  // namespace mutation_test
}  // namespace polhode::checker
