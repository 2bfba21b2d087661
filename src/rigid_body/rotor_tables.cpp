#include "rigid_body/rotor_tables.hpp"

#include "polhode/elliptic/carlson.hpp"
#include "polhode/rigid_body/jacobi_start.hpp"

namespace polhode::detail {
namespace {

/// The n from which terms of the size of p^(n(n-1)) 2^n (2n+1) are below 2^-bits: what is left out
/// has its own bounds.
std::size_t terms_for(const ball& nome, precision bits) {
  const magnitude size = nome.magnitude_upper();
  if (size.is_zero()) return 1;
  const std::int64_t log2 = -(size.log2_floor() + 1);  // at least 3
  std::size_t n = 2;
  constexpr std::size_t most = 1 << 16;
  while (n < most && log2 > 0) {
    const auto m = static_cast<std::int64_t>(n);
    if (log2 >= bits || (m * (m - 1) * log2) - 2 * m - 4 > bits) break;
    ++n;
  }
  return n;
}

/// q^(n^2) for n < count; one more beyond the last for the bounds.
std::vector<ball> square_powers(const ball& q, std::size_t count) {
  std::vector<ball> result;
  result.reserve(count + 1);
  ball power(1, q.precision());
  ball step = q;
  const ball q2 = square(q);
  for (std::size_t n = 0; n <= count; ++n) {
    result.push_back(power);
    power *= step;  // q^(n^2) q^(2n+1)
    step *= q2;
  }
  return result;
}

magnitude product(const ball& x, long n) { return (x * n).magnitude_upper(); }

ball alternating(const ball& x, std::size_t n) { return n % 2 == 0 ? x : -x; }

}  // namespace

/// Of 1 and this.
ball rotor_tables::counted_agm(const ball& second) {
  ++work.integrals;
  return agm(ball(1, second.precision()), second);
}

/// alpha with sc(alpha | 1-m) = 1/sqrt kappa: s R_F(1, 1 + m s^2, 1 + s^2), s = 1/sqrt kappa (DLMF
/// 22.15.20).
ball rotor_tables::pole(const exact_real& m, const exact_real& kappa, precision bits) {
  const exact_real square = 1 / kappa;
  ++work.integrals;
  return sqrt(square.at(bits)) *
         carlson_rf(ball(1, bits), (1 + m * square).at(bits), (1 + square).at(bits));
}

rotor_tables::rotor_tables(const initial_state& state, precision bits, std::size_t terms)
    : terms_(terms) {
  const motion& of = state.motion();
  const exact_real& moment = state.tensor().moments()[1];
  size = sqrt(state.squared_momentum().at(bits));
  const ball unit = sqrt((state.squared_momentum() / (moment * moment)).at(bits));
  const ball per_turn = unit / scale(pi(bits), 1);

  if (is_equilibrium(state.regime())) {
    for (std::size_t i = 0; i < 3; ++i)
      amplitude[i] = sqrt(state.direction_squares()[i].at(bits)) * state.direction_signs()[i];
    // J parallel to omega: omega = J/I with 2 H/J^2 = 1/I.
    rates = {ball(0, bits), ball(0, bits), per_turn * (1 + of.c()), ball(0, bits), 0};
    return;
  }

  const bool oscillating = of.regime() == regime::oscillating;
  const bool forever = of.regime() == regime::separatrix;
  const exact_real m = of.m();
  const auto [x2, y2, z2] = of.greatest_squares();
  const ball lambda = sqrt(of.lambda2().at(bits));
  const ball agm1 = forever ? ball(0, bits) : counted_agm(sqrt(of.m1().at(bits)));

  // Either holds for every m; the nome is the smaller, and where m is about 1/2 both are.
  if (certainly_less(ball(rational(1, 2), 64), m.at(64))) {
    set_hyperbolic(of, m, agm1, lambda, bits);
  } else {
    set_circular(of, m, agm1, lambda, bits);
  }
  amplitude = {-sqrt(x2.at(bits)), sqrt(y2.at(bits)), sqrt(z2.at(bits))};
  amplitude[0] *= oscillating ? series.of_dn : series.of_cn;
  amplitude[1] *= series.of_sn;
  amplitude[2] *= oscillating ? series.of_cn : series.of_dn;

  const jacobi_start start = jacobi_start_of(state);
  const bool back = start.cosine < 0;                                // sn(2K - u) = sn u
  const ball per_cycle = forever ? ball(1, bits) : agm1 / pi(bits);  // 1/(2K)
  ball u0(0, bits);
  if (start.sine != 0) {
    ++work.integrals;
    u0 = start.distance(bits) * per_cycle * start.sine;
  }
  rates.cycles = unit * lambda * per_cycle;
  rates.cycles_0 = back ? -u0 : u0;
  rates.half_turns_0 = back ? 1 : 0;
  rates.turns = per_turn * mu_;
}

void rotor_tables::set_circular(const motion& of, const exact_real& m, const ball& agm1,
                                const ball& lambda, precision bits) {
  const exact_real kappa = of.kappa();
  const ball one(1, bits);
  series.hyperbolic = false;
  series.scale = pi(bits);
  ball& q = series.nome;
  q = m.sign() == 0 ? ball(0, bits) : exp(-(pi(bits) * agm1 / counted_agm(sqrt(m.at(bits)))));
  const std::size_t count = terms_ > 0 ? terms_ : terms_for(q, bits);
  const std::vector<ball> squares = square_powers(q, count);

  // E = e^(-2 eta), where for kappa = 0 (then m = 0 too) eta is infinite: tanh eta = 1.
  ball rate = one;  // Y
  if (kappa.sign() == 0) {
    series.lag_sine = {one};
    series.lag_cosine = {one};
  } else {
    const ball eta = pole(m, kappa, bits) * agm1;
    // Each of E and 1 - E without cancellation.
    const ball exponent = scale(-eta, 1);
    const bool small = is_small(exponent);
    ball shrunk = small ? expm1(exponent) : ball(0, bits);
    const ball e = small ? 1 + shrunk : exp(exponent);
    if (!small) shrunk = e - 1;
    const ball tangent = -shrunk / (1 + e);  // tanh eta
    const ball ratio = q / e;                // q e^(2 eta), below 1
    ball power = one;                        // ratio^n
    ball en = e;                             // E^(2n+1)
    ball sigma = one;                        // 1 + E + ... + E^(2n)
    ball above(0, bits);
    ball below(0, bits);
    for (std::size_t n = 0; n < count; ++n) {
      const ball factor = alternating(squares[n] * power, n);
      series.lag_sine.push_back(factor * (1 + en) / (1 + e));
      series.lag_cosine.push_back(factor * sigma);
      above += series.lag_sine.back() * static_cast<long>(2 * n + 1);
      below += series.lag_cosine.back();
      sigma += en;
      en *= e;
      sigma += en;
      en *= e;
      power *= ratio;
    }
    const auto next = static_cast<long>(2 * count + 1);
    if (count > 1) {
      series.lag_sine_tail = product(squares[count], 2 * next);
      series.lag_cosine_tail =
          multiply_up(product(squares[count], 2 * next * next), tangent.magnitude_upper());
      // The sums without U_n, V_n have the same bounds.
      above = above.enlarged(series.lag_sine_tail);
      below = below.enlarged(product(squares[count], 2 * next));
    }
    for (ball& coefficient : series.lag_cosine) coefficient *= tangent;
    rate = above / (tangent * below);
  }
  std::vector<ball> odd;
  ball qn = one;
  for (std::size_t n = 0; n < count; ++n) {
    odd.push_back(squares[n] * qn);  // q^(n^2+n)
    qn *= q;
  }
  if (count > 1) {
    const auto next = static_cast<long>(2 * count + 1);
    series.odd_tail = product(squares[count] * qn, 2 * next);
    series.even_tail = product(squares[count], 4);
  }
  set_factors(odd, squares);
  series.even.assign(squares.begin(), squares.begin() + static_cast<std::ptrdiff_t>(count));
  for (std::size_t n = 0; n < count; ++n) series.odd.push_back(alternating(odd[n], n));
  mu_ = (1 - of.b()) + lambda * agm1 * rate;
  rates.slip = ball(rational(1, 2), bits);
}

void rotor_tables::set_hyperbolic(const motion& of, const exact_real& m, const ball& agm1,
                                  const ball& lambda, precision bits) {
  const ball one(1, bits);
  const ball agm0 = counted_agm(sqrt(m.at(bits)));  // pi/(2K')
  series.hyperbolic = true;
  const bool forever = of.regime() == regime::separatrix;
  series.scale = forever ? one : pi(bits) * agm0 / agm1;
  ball& p = series.nome;
  p = forever ? ball(0, bits) : exp(-series.scale);
  const std::size_t count = terms_ > 0 ? terms_ : terms_for(p, bits);
  const std::vector<ball> squares = square_powers(p, count);

  const ball beta = pole(m, of.kappa(), bits) * agm0;
  const auto [sine, cosine] = sin_cos(beta);
  const ball twice = 2 - scale(square(sine), 2);  // 2 cos 2 beta
  ball before(2, bits);
  ball e = twice;
  ball u = one;  // sin((2n+1)beta)/sin(beta)
  ball v = one;  // cos((2n+1)beta)/cos(beta)
  ball pn = one;
  ball above(0, bits);
  ball below(0, bits);
  std::vector<ball> odd;
  for (std::size_t n = 0; n < count; ++n) {
    const ball cos_n = cosine * v;
    series.odd.push_back(alternating(squares[n], n));
    series.lag_sine.push_back(series.odd.back() * cos_n);
    series.lag_cosine.push_back(series.odd.back() * (sine * u));
    // p^(n^2-n), which for n = 0 is not used.
    series.even.push_back(n == 0 ? one : odd.back());
    odd.push_back(squares[n] * pn);  // p^(n^2+n)
    above += alternating(odd.back() * cos_n, n) * static_cast<long>(2 * n + 1);
    below += alternating(odd.back() * u, n);
    pn *= p;
    u += e;
    v = e - v;
    ball next = twice * e - before;
    before = e;
    e = std::move(next);
  }
  const auto next = static_cast<long>(2 * count + 1);
  if (count > 1) {
    const ball last = scale(squares[count], static_cast<long>(count));  // 2^N p^(N^2)
    series.odd_tail = product(last, 2 * next);                          // 8 <= 2 (2N+1) for N >= 2
    series.even_tail = product(scale(odd.back(), static_cast<long>(count)), 4);
    series.lag_sine_tail = series.odd_tail;
    series.lag_cosine_tail = multiply_up(product(last, 8 * next), sine.magnitude_upper());
    const magnitude tail = product(squares[count] * pn, 2 * next);
    above = above.enlarged(tail);
    below = below.enlarged(tail);
  }
  set_factors(odd, squares);
  mu_ = (1 - of.b()) + lambda * agm0 * above / (sine * below);
  rates.slip = rational(1, 2) - beta / pi(bits);
}

/// theta_2(0)/(2 nome^(1/4)), theta_3(0), theta_4(0), and from them the factors of sn, cn, dn.
void rotor_tables::set_factors(const std::vector<ball>& odd_powers,
                               const std::vector<ball>& even_powers) {
  const std::size_t count = odd_powers.size();
  // The bounds hold for nomes up to 1/16, which all are.
  if (!(series.nome.magnitude_upper() <= magnitude::power_of_two(-4))) {
    series.odd_tail = series.even_tail = series.lag_sine_tail = series.lag_cosine_tail =
        magnitude::infinity();
  }
  ball second = odd_powers[0];
  ball third = odd_powers[0];
  ball fourth = odd_powers[0];
  for (std::size_t n = 1; n < count; ++n) {
    second += odd_powers[n];
    third += scale(even_powers[n], 1);
    fourth += alternating(scale(even_powers[n], 1), n);
  }
  if (count > 1) {
    second = second.enlarged(series.odd_tail);
    const magnitude tail = product(even_powers[count], 4);
    third = third.enlarged(tail);
    fourth = fourth.enlarged(tail);
  }
  if (series.hyperbolic) {
    series.of_sn = third / fourth;
    series.of_cn = scale(second / fourth, 1);
    series.of_dn = scale(second / third, 1);
  } else {
    series.of_sn = third / second;
    series.of_cn = fourth / second;
    series.of_dn = fourth / third;
  }
}

}  // namespace polhode::detail
