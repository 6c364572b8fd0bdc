// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_algebra.hpp"

#include <vector>

#include "core/vector/level.hpp"

namespace granum::network {

namespace {

using elastic::Matrix6;

Gram gram(const Matrix6& m) {
  Gram g;
  for (int r = 0; r < load_cases; ++r)
    for (int c = 0; c < load_cases; ++c)
      g.row[r][c] = m(r, c);
  return g;
}

Matrix6 sum(const std::vector<Gram>& parts) {
  Gram whole;
  for (const Gram& part : parts)
    for (int r = 0; r < load_cases; ++r)
      whole.row[r] += part.row[r];
  Matrix6 m;
  for (int r = 0; r < load_cases; ++r)
    for (int c = 0; c < load_cases; ++c)
      m(r, c) = whole.row[r][c];
  return m;
}

GRANUM_INLINE void add_products(const Lanes& x, const Lanes& y, Lanes* total) {
  for (int c = 0; c < load_cases; ++c)
    total[c] += x[c] * y;
}

/// value += x m
GRANUM_INLINE void add_combination(const Lanes& x, const Gram& m, Lanes& value) {
  for (int c = 0; c < load_cases; ++c)
    value += x[c] * m.row[c];
}

template <int Dof>
GRANUM_INLINE void products_of(std::size_t n, const Rows<Dof>* x, const Rows<Dof>* y, Gram* out) {
  Lanes total[load_cases] = {};
  for (std::size_t g = 0; g < n; ++g)
    for (int d = 0; d < Dof; ++d)
      add_products(x[g].row[d], y[g].row[d], total);
  for (int c = 0; c < load_cases; ++c)
    out->row[c] = total[c];
}

template <int Dof>
GRANUM_INLINE void advance_rows(std::size_t n, const Rows<Dof>* p, const Gram* a, Rows<Dof>* q,
                                const Rows<Dof>* s, const Gram* b, Rows<Dof>* w, Gram* out) {
  Lanes total[load_cases] = {};
  for (std::size_t g = 0; g < n; ++g)
    for (int d = 0; d < Dof; ++d) {
      add_combination(p[g].row[d], *a, q[g].row[d]);
      add_combination(s[g].row[d], *b, w[g].row[d]);
      add_products(w[g].row[d], w[g].row[d], total);
    }
  for (int c = 0; c < load_cases; ++c)
    out->row[c] = total[c];
}

template <int Dof>
GRANUM_INLINE void turn_rows(std::size_t n, const Gram* t, Rows<Dof>* w, const Rows<Dof>* z, const Gram* c,
                             Rows<Dof>* p) {
  for (std::size_t g = 0; g < n; ++g)
    for (int d = 0; d < Dof; ++d) {
      Lanes residual = {}, direction = {};
      add_combination(w[g].row[d], *t, residual);
      add_combination(z[g].row[d], *t, direction);
      add_combination(p[g].row[d], *c, direction);
      w[g].row[d] = residual;
      p[g].row[d] = direction;
    }
}

} // namespace

template <int Dof>
Matrix6 products(const Workers& workers, const Field<Dof>& x, const Field<Dof>& y) {
  std::vector<Gram> parts(Workers::block_count(x.size()));
  workers.blocks(x.size(), [&](std::size_t block, std::size_t first, std::size_t last) {
    at_vector_level([&](auto) __attribute__((always_inline)) {
      products_of<Dof>(last - first, &x[first], &y[first], &parts[block]);
    });
  });
  return sum(parts);
}

template <int Dof>
Matrix6 advance(const Workers& workers, const Field<Dof>& p, const Matrix6& a, Field<Dof>& q,
                const Field<Dof>& s, const Matrix6& b, Field<Dof>& w) {
  const Gram along = gram(a), back = gram(b);
  std::vector<Gram> parts(Workers::block_count(p.size()));
  workers.blocks(p.size(), [&](std::size_t block, std::size_t first, std::size_t last) {
    at_vector_level([&](auto) __attribute__((always_inline)) {
      advance_rows<Dof>(last - first, &p[first], &along, &q[first], &s[first], &back, &w[first],
                        &parts[block]);
    });
  });
  return sum(parts);
}

template <int Dof>
void turn(const Workers& workers, const Matrix6& t, Field<Dof>& w, const Field<Dof>& z, const Matrix6& c,
          Field<Dof>& p) {
  const Gram fresh = gram(t), kept = gram(c);
  workers.blocks(w.size(), [&](std::size_t, std::size_t first, std::size_t last) {
    at_vector_level([&](auto) __attribute__((always_inline)) {
      turn_rows<Dof>(last - first, &fresh, &w[first], &z[first], &kept, &p[first]);
    });
  });
}

template Matrix6 products<3>(const Workers&, const Field<3>&, const Field<3>&);
template Matrix6 products<6>(const Workers&, const Field<6>&, const Field<6>&);
template Matrix6 advance<3>(const Workers&, const Field<3>&, const Matrix6&, Field<3>&, const Field<3>&,
                            const Matrix6&, Field<3>&);
template Matrix6 advance<6>(const Workers&, const Field<6>&, const Matrix6&, Field<6>&, const Field<6>&,
                            const Matrix6&, Field<6>&);
template void turn<3>(const Workers&, const Matrix6&, Field<3>&, const Field<3>&, const Matrix6&, Field<3>&);
template void turn<6>(const Workers&, const Matrix6&, Field<6>&, const Field<6>&, const Matrix6&, Field<6>&);

} // namespace granum::network
