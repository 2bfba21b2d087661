#pragma once

// Formulas of Machin's kind for the logarithms of the first primes p_j and for twice the arguments
// of Gaussian primes a_j + b_j i:
//     log p_j = sum over k of w_jk atanh(1/x_k),  2 arg(a_j + b_j i) = sum of v_jk atan(1/y_k).
// The x_k and y_k are great numbers, so that the series are short (J. Todd, A problem on arc
// tangent relations, 1949; F. Johansson, Computing elementary functions using multi-prime argument
// reduction, 2022). The compiler proves the formulas: e^(2 atanh(1/x)) = (x + 1)/(x - 1), and y + i
// has the argument atan(1/y).

#include <array>
#include <cstddef>
#include <cstdint>

namespace polhode::detail::fixed_point {

inline constexpr std::size_t prime_count = 13;
using prime_matrix = std::array<std::array<std::int64_t, prime_count>, prime_count>;

inline constexpr std::array<std::int64_t, prime_count> primes = {2,  3,  5,  7,  11, 13, 17,
                                                                 19, 23, 29, 31, 37, 41};
inline constexpr std::array<std::int64_t, prime_count> logarithm_arguments = {
    51744295,   170918749,  265326335,  287080366,  362074049,   587270881,   831409151,
    2470954914, 3222617399, 6926399999, 9447152318, 90211378321, 127855050751};
inline constexpr prime_matrix logarithm_weights = {{
    {{3191278, 35138256, 17325186, 62225852, 26216928, 22419280, 9733920, 31220668, 40902078,
      -34447972, 9161220, 6323462, 19491222}},
    {{5058056, 55692818, 27459770, 98625642, 41552848, 35533718, 15427898, 49483588, 64828260,
      -54598744, 14520190, 10022450, 30892856}},
    {{7409918, 81588504, 40227836, 144483954, 60873822, 52055956, 22601462, 72492146, 94971684,
      -79985714, 21271694, 14682624, 45257216}},
    {{8959050, 98645556, 48637946, 174690052, 73600222, 62938876, 27326568, 87647496, 114826650,
      -96707684, 25718796, 17752202, 54718778}},
    {{11040008, 121558394, 59935296, 215266080, 90695670, 77557966, 33673830, 108005766, 141497942,
      -119170404, 31692614, 21875584, 67428550}},
    {{11809132, 130026998, 64110806, 230263014, 97014162, 82961194, 36019784, 115530200, 151355674,
      -127472644, 33900542, 23399590, 72126092}},
    {{13044230, 143626316, 70816054, 254345858, 107160720, 91637974, 39787036, 127613320, 167185724,
      -140804806, 37446146, 25846916, 79669646}},
    {{13556318, 149264764, 73596134, 264330908, 111367610, 95235476, 41348986, 132623134, 173749062,
      -146332488, 38916198, 26861608, 82797298}},
    {{14435944, 158950078, 78371552, 281482496, 118593898, 101415002, 44031990, 141228626,
      185023084, -155827536, 41441346, 28604572, 88169750}},
    {{15503168, 170700980, 84165424, 302292006, 127361338, 108912436, 47287198, 151669412,
      198701518, -167347594, 44505032, 30719258, 94687986}},
    {{15810218, 174081818, 85832372, 308279086, 129883808, 111069514, 48223750, 154673318,
      202636924, -170662016, 45386482, 31327672, 96563340}},
    {{16624814, 183051106, 90254748, 324162674, 136575864, 116792194, 50708402, 162642614,
      213077468, -179455104, 47724948, 32941780, 101538612}},
    {{17097438, 188255034, 92820584, 333378238, 140458556, 120112458, 52149982, 167266352,
      219135010, -184556802, 49081712, 33878276, 104425236}},
}};

struct gaussian_integer {
  std::int64_t re;
  std::int64_t im;
};
/// 1 + i, and one of each pair of conjugates.
inline constexpr std::array<gaussian_integer, prime_count> gaussian_primes = {{{1, 1},
                                                                               {2, 1},
                                                                               {3, 2},
                                                                               {4, 1},
                                                                               {5, 2},
                                                                               {6, 1},
                                                                               {5, 4},
                                                                               {7, 2},
                                                                               {6, 5},
                                                                               {8, 3},
                                                                               {8, 5},
                                                                               {9, 4},
                                                                               {10, 1}}};
inline constexpr std::array<std::int64_t, prime_count> angle_arguments = {
    683982,   1984933,  2343692,  2809305,   3014557,   6225244,   6367252,
    18975991, 22709274, 24208144, 193788912, 201229582, 2189376182};
inline constexpr prime_matrix angle_weights = {{
    {{893758, -387440, 344740, 738156, 36462, -653018, 732158, 560616, 202968, -58948, -1125574,
      -560064, -432616}},
    {{527616, -228719, 203512, 435759, 21525, -385499, 432218, 330951, 119819, -34799, -664465,
      -330625, -255388}},
    {{669128, -290064, 258096, 552634, 27298, -488894, 548144, 419716, 151956, -44132, -842682,
      -419302, -323886}},
    {{278778, -120849, 107530, 230243, 11373, -203687, 228372, 174865, 63309, -18387, -351085,
      -174693, -134940}},
    {{433004, -187705, 167018, 357619, 17665, -316371, 354712, 271605, 98333, -28559, -545313,
      -271337, -209592}},
    {{187934, -81469, 72490, 155215, 7667, -137313, 153954, 117883, 42679, -12395, -236679, -117767,
      -90968}},
    {{767834, -332853, 296168, 634155, 31325, -561013, 629002, 481629, 174371, -50643, -966989,
      -481155, -371664}},
    {{316696, -137286, 122156, 261560, 12920, -231392, 259434, 198650, 71920, -20888, -398838,
      -198454, -153294}},
    {{790590, -342717, 304946, 652949, 32253, -577639, 647644, 495903, 179539, -52143, -995647,
      -495415, -382678}},
    {{408270, -176984, 157478, 337190, 16656, -298300, 334450, 256090, 92716, -26928, -514164,
      -255838, -197620}},
    {{635668, -275559, 245190, 524999, 25933, -464447, 520734, 398727, 144357, -41925, -800543,
      -398335, -307690}},
    {{475926, -206312, 183574, 393068, 19416, -347732, 389874, 298528, 108080, -31390, -599368,
      -298234, -230368}},
    {{113420, -49167, 43748, 93673, 4627, -82869, 92912, 71143, 25757, -7481, -142837, -71073,
      -54900}},
}};

namespace prime_formulas_impl {

/// How often p divides n, and n without these factors.
constexpr std::int64_t take_out(std::int64_t& n, std::int64_t p) {
  std::int64_t exponent = 0;
  for (; n % p == 0; n /= p) ++exponent;
  return exponent;
}

/// The exponents of the primes in (x + 1)/(x - 1); all zero where there are other primes.
constexpr std::array<std::int64_t, prime_count> exponents_beside(std::int64_t x) {
  std::array<std::int64_t, prime_count> result{};
  std::int64_t above = x + 1;
  std::int64_t below = x - 1;
  for (std::size_t l = 0; l < prime_count; ++l) {
    result[l] = take_out(above, primes[l]) - take_out(below, primes[l]);
  }
  if (above != 1 || below != 1) return {};
  return result;
}

/// The exponents e of y + i = (unit) times the product of pi^e, negative for those of conjugates:
/// an argument is then the sum of e arg(pi). That of 1 + i counts the unit as well, i being worth
/// two; it is known modulo 8.
constexpr std::array<std::int64_t, prime_count> exponents_of_argument(std::int64_t y) {
  std::array<std::int64_t, prime_count> result{};
  gaussian_integer rest{y, 1};
  const auto divide = [&rest](gaussian_integer d) {
    const std::int64_t norm = d.re * d.re + d.im * d.im;
    const std::int64_t re = rest.re * d.re + rest.im * d.im;
    const std::int64_t im = rest.im * d.re - rest.re * d.im;
    if (re % norm != 0 || im % norm != 0) return false;
    rest = {re / norm, im / norm};
    return true;
  };
  for (std::size_t l = 0; l < prime_count; ++l) {
    const gaussian_integer prime = gaussian_primes[l];
    while (divide(prime)) ++result[l];
    while (l > 0 && divide({prime.re, -prime.im})) --result[l];
  }
  while (rest.re != 1 || rest.im != 0) {
    if (rest.re * rest.re + rest.im * rest.im != 1) return {};
    rest = {rest.im, -rest.re};  // over i
    result[0] += 2;
  }
  return result;
}

/// Whether the rows of `weights` make twice the unit vectors of those exponents, where those of the
/// first prime count modulo `modulus` if that is not 0.
constexpr bool make_twice_each_prime(const prime_matrix& weights, const prime_matrix& exponents,
                                     std::int64_t modulus) {
  for (std::size_t j = 0; j < prime_count; ++j) {
    for (std::size_t l = 0; l < prime_count; ++l) {
      std::int64_t sum = j == l ? -2 : 0;
      for (std::size_t k = 0; k < prime_count; ++k) sum += weights[j][k] * exponents[k][l];
      if (l == 0 && modulus != 0) sum %= modulus;
      if (sum != 0) return false;
    }
  }
  return true;
}

template <class Exponents>
constexpr prime_matrix all(const std::array<std::int64_t, prime_count>& arguments, Exponents of) {
  prime_matrix result{};
  for (std::size_t k = 0; k < prime_count; ++k) result[k] = of(arguments[k]);
  return result;
}

static_assert(make_twice_each_prime(logarithm_weights, all(logarithm_arguments, exponents_beside),
                                    0));
// e^(i v) for the sum v of row j is then the unit number (pi_j/|pi_j|)^2: v is 2 arg(pi_j) but for
// a multiple of 2 pi, which does not matter here.
static_assert(make_twice_each_prime(angle_weights, all(angle_arguments, exponents_of_argument), 8));

}  // namespace prime_formulas_impl
}  // namespace polhode::detail::fixed_point
