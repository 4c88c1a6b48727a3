// Matrices of FLINT that free themselves.
#pragma once

#include <flint/fmpq_mat.h>
#include <flint/fmpz_mat.h>

#include <cstddef>
#include <cstdint>

#include "base/number/rational.hpp"

namespace slipproof {

/// A matrix of integers, initially 0.
class FlintMatrix {
 public:
  FlintMatrix(std::size_t rows, std::size_t columns) {
    fmpz_mat_init(value_, static_cast<slong>(rows), static_cast<slong>(columns));
  }
  ~FlintMatrix() { fmpz_mat_clear(value_); }
  FlintMatrix(const FlintMatrix&) = delete;
  FlintMatrix& operator=(const FlintMatrix&) = delete;

  fmpz_mat_struct* get() { return value_; }
  fmpz* at(std::size_t i, std::size_t j) {
    return fmpz_mat_entry(value_, static_cast<slong>(i), static_cast<slong>(j));
  }
  /// mantissa 2^exponent, an integer.
  void set(std::size_t i, std::size_t j, std::int64_t mantissa, int exponent) {
    fmpz_set_si(at(i, j), mantissa);
    fmpz_mul_2exp(at(i, j), at(i, j), static_cast<ulong>(exponent));
  }

 private:
  fmpz_mat_t value_;
};

/// A matrix of rational numbers, initially 0.
class FlintRationalMatrix {
 public:
  FlintRationalMatrix(std::size_t rows, std::size_t columns) {
    fmpq_mat_init(value_, static_cast<slong>(rows), static_cast<slong>(columns));
  }
  ~FlintRationalMatrix() { fmpq_mat_clear(value_); }
  FlintRationalMatrix(const FlintRationalMatrix&) = delete;
  FlintRationalMatrix& operator=(const FlintRationalMatrix&) = delete;

  fmpq_mat_struct* get() { return value_; }
  Rational at(std::size_t i, std::size_t j) const {
    return Rational(fmpq_mat_entry(value_, static_cast<slong>(i), static_cast<slong>(j)));
  }
  void set(std::size_t i, std::size_t j, const Rational& x) {
    const fmpq value = x.flint();
    fmpq_set(fmpq_mat_entry(value_, static_cast<slong>(i), static_cast<slong>(j)), &value);
  }
  Rational determinant() const {
    fmpq_t value;
    fmpq_init(value);
    fmpq_mat_det(value, value_);
    Rational result(value);
    fmpq_clear(value);
    return result;
  }

 private:
  fmpq_mat_t value_;
};

}  // namespace slipproof
