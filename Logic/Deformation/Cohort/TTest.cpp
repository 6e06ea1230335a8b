#include "Logic/Deformation/Cohort/TTest.h"

#include <cmath>

#include "Logic/Core/IncompleteBeta.h"

namespace falciform {

namespace {

bool canBeTested(const SampleMoments& a, const SampleMoments& b) {
  return a.count >= 2 && b.count >= 2 && a.sd + b.sd > 0;
}

TTest tested(double difference, double standardError, double degrees) {
  const double t = difference / standardError;
  return {t, degrees, studentTwoSided(t, degrees)};
}

}  // namespace

SampleMoments sampleMoments(const std::vector<double>& values) {
  SampleMoments moments;
  moments.count = static_cast<Index>(values.size());
  if (values.empty()) return moments;
  const auto n = static_cast<double>(values.size());
  double sum = 0, squares = 0;
  for (const double value : values) sum += value;
  moments.mean = sum / n;
  if (values.size() < 2) return moments;
  for (const double value : values) squares += (value - moments.mean) * (value - moments.mean);
  moments.sd = std::sqrt(squares / (n - 1));
  return moments;
}

double studentTwoSided(double t, double degrees) {
  return incompleteBeta(degrees / 2, 0.5, degrees / (degrees + t * t));
}

TTest pooledTTest(const SampleMoments& a, const SampleMoments& b) {
  if (!canBeTested(a, b)) return {};
  const auto n = static_cast<double>(a.count), m = static_cast<double>(b.count);
  const double variance = ((n - 1) * a.sd * a.sd + (m - 1) * b.sd * b.sd) / (n + m - 2);
  return tested(a.mean - b.mean, std::sqrt(variance * (1 / n + 1 / m)), n + m - 2);
}

TTest welchTTest(const SampleMoments& a, const SampleMoments& b) {
  if (!canBeTested(a, b)) return {};
  const auto n = static_cast<double>(a.count), m = static_cast<double>(b.count);
  const double va = a.sd * a.sd / n, vb = b.sd * b.sd / m;
  const double degrees = (va + vb) * (va + vb) / (va * va / (n - 1) + vb * vb / (m - 1));
  return tested(a.mean - b.mean, std::sqrt(va + vb), degrees);
}

}  // namespace falciform
