// Run time against error of Pinocchio's articulated-body algorithm under RK4 and DOP853 on the yardsticks of BENCHMARKS.md.
//
// pinocchio SCENE BODIES END REFERENCE: SCENE is "pins" (A) or "balls" (C); prints lines "rule,parameter,evaluations,error,seconds".
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/kinematics.hpp>



#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "dop853.hpp"  // A, B, C, E3, E5 of DOP853, written by rivals.py

using Vector = Eigen::VectorXd;
namespace pin = pinocchio;

struct Scene {
    pin::Model model;
    pin::Data data;
    bool balls;
    Vector tau;
    long evaluations = 0;

    Scene(bool balls, int n) : balls(balls) {
        const double l = 1.0 / n, m = 1.0 / n;
        pin::JointIndex parent = 0;
        for (int k = 0; k < n; ++k) {
            const pin::SE3 place(Eigen::Matrix3d::Identity(), Eigen::Vector3d(k ? l : 0.0, 0.0, 0.0));
            const std::string name = "joint" + std::to_string(k);
            Eigen::Matrix3d inertia;
            if (balls) {
                parent = model.addJoint(parent, pin::JointModelSpherical(), place, name);
                const double across = m * l * l * (1.0 / 12.0 + 1.0 / 400.0);
                inertia = Eigen::Vector3d(m * l * l / 200.0, across, across).asDiagonal();
            } else {
                parent = model.addJoint(parent, pin::JointModelRZ(), place, name);
                inertia = Eigen::Vector3d(0.0, m * l * l / 12.0, m * l * l / 12.0).asDiagonal();
            }
            model.appendBodyToJoint(parent, pin::Inertia(m, Eigen::Vector3d(0.5 * l, 0.0, 0.0), inertia));
        }
        model.gravity.linear() = Eigen::Vector3d(0.0, -9.81, 0.0);
        data = pin::Data(model);
        tau = Vector::Zero(model.nv);
    }

    // y = (q, v): quaternions are integrated as they are and normalised after each step.
    void slope(const Vector& y, Vector& dy) {
        const auto q = y.head(model.nq);
        const auto v = y.tail(model.nv);
        dy.tail(model.nv) = pin::aba(model, data, q, v, tau);
        if (balls) {
            for (int k = 0; k < model.nv / 3; ++k) {
                const Eigen::Quaterniond turn(q[4 * k + 3], q[4 * k], q[4 * k + 1], q[4 * k + 2]);
                const Eigen::Quaterniond spin(0.0, v[3 * k], v[3 * k + 1], v[3 * k + 2]);
                dy.segment<4>(4 * k) = 0.5 * (turn * spin).coeffs();
            }
        } else {
            dy.head(model.nq) = v;
        }
        ++evaluations;
    }

    void land(Vector& y) const {
        for (int k = 0; balls && k < model.nv / 3; ++k) y.segment<4>(4 * k).normalize();
    }

    Vector start() const {
        Vector y = Vector::Zero(model.nq + model.nv);
        for (int k = 0; balls && k < model.nv / 3; ++k) y[4 * k + 3] = 1.0;
        // The first body alone turns; rates of joints are relative.
        if (balls) y.segment<2>(model.nq) << 1.0, 2.0;
        if (balls && model.nv > 3) y.segment<2>(model.nq + 3) << -1.0, -2.0;
        return y;
    }
};

static Vector rk4(Scene& scene, double end, double step) {
    const long count = std::lround(end / step);
    const double h = end / count;
    Vector y = scene.start();
    Vector a(y.size()), b(y.size()), c(y.size()), d(y.size()), at(y.size());
    for (long i = 0; i < count; ++i) {
        scene.slope(y, a);
        at.noalias() = y + 0.5 * h * a;
        scene.slope(at, b);
        at.noalias() = y + 0.5 * h * b;
        scene.slope(at, c);
        at.noalias() = y + h * c;
        scene.slope(at, d);
        y.noalias() += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
        scene.land(y);
    }
    return y;
}

// Hairer's DOP853: error control with absolute and relative tolerances, no dense output.
static Vector dop853(Scene& scene, double end, double tolerance) {
    Vector y = scene.start();
    std::array<Vector, 13> k;
    for (auto& slope : k) slope = Vector::Zero(y.size());
    Vector at(y.size()), next(y.size()), third(y.size()), fifth(y.size());
    scene.slope(y, k[0]);
    double t = 0.0, h = std::min(end, 0.01 * std::pow(tolerance, 1.0 / 8.0));
    while (t < end) {
        h = std::min(h, end - t);
        for (int i = 1; i < 12; ++i) {
            at = y;
            for (int j = 0; j < i; ++j)
                if (A[i][j] != 0.0) at.noalias() += h * A[i][j] * k[j];
            scene.slope(at, k[i]);
        }
        next = y;
        third.setZero();
        fifth.setZero();
        for (int j = 0; j < 12; ++j) {
            if (B[j] != 0.0) next.noalias() += h * B[j] * k[j];
            if (E3[j] != 0.0) third.noalias() += E3[j] * k[j];
            if (E5[j] != 0.0) fifth.noalias() += E5[j] * k[j];
        }
        double five = 0.0, three = 0.0;
        for (Eigen::Index i = 0; i < y.size(); ++i) {
            const double scale = tolerance * (1.0 + std::max(std::abs(y[i]), std::abs(next[i])));
            five += std::pow(fifth[i] / scale, 2);
            three += std::pow(third[i] / scale, 2);
        }
        const double size = five + 0.01 * three;
        const double error = size > 0.0 ? h * five / std::sqrt(size * y.size()) : 0.0;
        const double factor = std::min(6.0, std::max(1.0 / 3.0, 0.9 * std::pow(std::max(error, 1e-12), -1.0 / 8.0)));
        if (error <= 1.0) {
            t += h;
            y = next;
            scene.land(y);
            scene.slope(y, k[0]);
            h *= factor;
        } else {
            h *= std::min(0.9, factor);
        }
    }
    return y;
}

int main(int argc, char** argv) {
    if (argc < 5) return 1;
    const bool balls = std::string(argv[1]) == "balls";
    const int n = std::atoi(argv[2]);
    const double end = std::atof(argv[3]), reference = std::atof(argv[4]);
    Scene scene(balls, n);
    const auto read = [&](const Vector& y) {
        if (!balls) return y.head(n).sum();  // the absolute angle of the last rod
        pin::forwardKinematics(scene.model, scene.data, y.head(scene.model.nq));
        return (scene.data.oMi[n].act(Eigen::Vector3d(1.0 / n, 0.0, 0.0)))[1];  // height of the tip
    };
    const auto measure = [&](const char* rule, double parameter, auto run) {
        std::vector<double> seconds;
        double found = 0.0;
        long evaluations = 0;
        const auto begin = std::chrono::steady_clock::now();
        while (seconds.size() < 3 || (std::chrono::steady_clock::now() - begin < std::chrono::milliseconds(30) && seconds.size() < 1000)) {
            scene.evaluations = 0;
            const auto start = std::chrono::steady_clock::now();
            const Vector y = run(scene, end, parameter);
            seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
            found = read(y);
            evaluations = scene.evaluations;
        }
        std::nth_element(seconds.begin(), seconds.begin() + seconds.size() / 2, seconds.end());
        std::printf("%s,%.6e,%ld,%.6e,%.6e,%.15g\n", rule, parameter, evaluations, std::abs(found - reference), seconds[seconds.size() / 2], found);
    };
    const double coarse = balls ? 0.02 : (n > 2 ? 0.004 : 0.02);
    for (double step = coarse; step > coarse / 250.0; step *= std::sqrt(0.5)) measure("RK4", step, rk4);
    for (double tolerance = 1e-3; tolerance > 0.5e-13; tolerance *= 0.1) measure("DOP853", tolerance, dop853);
}
