// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/analysis/fieldsphere.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace {

constexpr std::size_t kFewestPoints = 12;
constexpr std::size_t kFewestForStretch = 60;
constexpr double kFlattest = 0.12;  // narrowest by widest spread: less is a plane
constexpr double kAtRest = 0.08;  // widest spread, of the field: less is noise
constexpr double kLongestStretch = 3;  // more is no ellipsoid that iron makes

Vector3 meanOf(std::span<const Vector3> points)
{
    return std::accumulate(points.begin(), points.end(), Vector3{}) / double(points.size());
}

// Standard deviations along the three directions in which the points lie apart, narrowest first.
Eigen::Vector3d deviationsOf(std::span<const Vector3> points, const Vector3 &mean)
{
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const Vector3 &point : points) {
        const Eigen::Vector3d off(point.x - mean.x, point.y - mean.y, point.z - mean.z);
        sum += off * off.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(sum / double(points.size()),
                                                                Eigen::EigenvaluesOnly);
    return solver.eigenvalues().cwiseMax(0).cwiseSqrt();
}

}  // namespace

std::optional<FieldSphere> fitFieldSphere(std::span<const Vector3> points)
{
    if (points.size() < kFewestPoints)
        return {};
    const Vector3 mean = meanOf(points);
    const Eigen::Vector3d spread = deviationsOf(points, mean);
    if (spread[2] < kAtRest * mean.norm() || spread[0] < kFlattest * spread[2] || spread[2] <= 0)
        return {};
    // |p|² = 2 p·c + (r² - |c|²), about the mean and in units of the spread.
    Eigen::MatrixXd rows(Eigen::Index(points.size()), 4);
    Eigen::VectorXd squares(rows.rows());
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
        const Vector3 point = (points[std::size_t(i)] - mean) / spread[2];
        rows.row(i) << 2 * point.x, 2 * point.y, 2 * point.z, 1;
        squares[i] = point.norm() * point.norm();
    }
    const Eigen::Vector4d found = rows.colPivHouseholderQr().solve(squares);
    FieldSphere sphere;
    sphere.centre = mean + Vector3{found[0], found[1], found[2]} * spread[2];
    sphere.radius = spread[2] * std::sqrt(std::max(0.0, found[3] + found.head<3>().squaredNorm()));
    if (sphere.radius <= 0)
        return {};
    double sum = 0;
    for (const Vector3 &point : points)
        sum += std::pow((point - sphere.centre).norm() - sphere.radius, 2);
    sphere.roughness = std::sqrt(sum / double(points.size())) / sphere.radius;
    return sphere;
}

std::optional<double> fieldStretch(std::span<const Vector3> points)
{
    const auto sphere = points.size() < kFewestForStretch ? std::nullopt : fitFieldSphere(points);
    if (!sphere)
        return {};
    // x'Qx + b'x = 1 about the sphere's centre, in radii.
    Eigen::MatrixXd rows(Eigen::Index(points.size()), 9);
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
        const Vector3 p = (points[std::size_t(i)] - sphere->centre) / sphere->radius;
        rows.row(i) << p.x * p.x, p.y * p.y, p.z * p.z, 2 * p.x * p.y, 2 * p.x * p.z, 2 * p.y * p.z, p.x, p.y,
            p.z;
    }
    const Eigen::VectorXd found = rows.colPivHouseholderQr().solve(Eigen::VectorXd::Ones(rows.rows()));
    Eigen::Matrix3d q;
    q << found[0], found[3], found[4], found[3], found[1], found[5], found[4], found[5], found[2];
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(q, Eigen::EigenvaluesOnly);
    const Eigen::Vector3d values = solver.eigenvalues();
    if (values[0] <= 0)
        return {};
    const double stretch = std::sqrt(values[2] / values[0]);
    return stretch > kLongestStretch ? std::nullopt : std::optional(stretch);
}

const std::array<Vector3, kFieldDirections> &fieldDirections()
{
    static const auto directions = [] {
        std::array<Vector3, kFieldDirections> all;
        std::size_t count = 0;
        for (int at = 0; at < 27; ++at) {
            const Vector3 way{double(at % 3 - 1), double(at / 3 % 3 - 1), double(at / 9 - 1)};
            if (way.norm() > 0)
                all[count++] = way / way.norm();
        }
        return all;
    }();
    return directions;
}

SeenDirections directionsSeen(std::span<const Vector3> points, const FieldSphere &sphere)
{
    SeenDirections seen;
    const auto &all = fieldDirections();
    for (const Vector3 &point : points) {
        const Vector3 way = point - sphere.centre;
        const auto along
            = [&way](const Vector3 &each) { return each.x * way.x + each.y * way.y + each.z * way.z; };
        const auto nearest = std::max_element(
            all.begin(), all.end(), [&](const Vector3 &a, const Vector3 &b) { return along(a) < along(b); });
        seen.set(std::size_t(nearest - all.begin()));
    }
    return seen;
}
