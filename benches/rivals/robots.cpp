// What Pinocchio's functions of robots take, and whether they say what another library says.
//
// robots time MODEL STATES: prints lines "function nanoseconds". robots check MODEL STATES: lines "function difference", the largest relative
// to the largest number. MODEL: a joint a line, as robots.py writes it; STATES: as the bench `times` of catena-urdf-robots writes them.
#include <pinocchio/algorithm/aba-derivatives.hpp>
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/frames.hpp>
#include <pinocchio/algorithm/jacobian.hpp>
#include <pinocchio/algorithm/rnea.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace pin = pinocchio;
using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

static pin::JointModel joint(const std::string& type, const Eigen::Vector3d& axis) {
    if (type == "JointModelRX") return pin::JointModelRX();
    if (type == "JointModelRY") return pin::JointModelRY();
    if (type == "JointModelRZ") return pin::JointModelRZ();
    if (type == "JointModelRUBZ") return pin::JointModelRUBZ();
    if (type == "JointModelPX") return pin::JointModelPX();
    if (type == "JointModelPY") return pin::JointModelPY();
    if (type == "JointModelPZ") return pin::JointModelPZ();
    if (type == "JointModelRevoluteUnaligned") return pin::JointModelRevoluteUnaligned(axis);
    if (type == "JointModelPrismaticUnaligned") return pin::JointModelPrismaticUnaligned(axis);
    if (type == "JointModelPlanar") return pin::JointModelPlanar();
    if (type == "JointModelFreeFlyer") return pin::JointModelFreeFlyer();
    throw std::runtime_error(type);
}

static pin::Model read(const char* path) {
    pin::Model model;
    std::ifstream file(path);
    std::string type, name;
    pin::JointIndex parent;
    while (file >> type >> parent >> name) {
        double x[28];
        for (double& number : x) file >> number;
        const auto turn = [](const double* from) { return Eigen::Matrix3d(Eigen::Map<const Rows>(from, 3, 3)); };
        const auto vector = [](const double* from) { return Eigen::Vector3d(from[0], from[1], from[2]); };
        const auto id = model.addJoint(parent, joint(type, vector(x + 12)), pin::SE3(turn(x + 3), vector(x)), name);
        model.appendBodyToJoint(id, pin::Inertia(x[15], vector(x + 16), turn(x + 19)));
        model.addJointFrame(id);
    }
    return model;
}

// A state, as the other library has it in `lists`, and as Pinocchio has it. The former's rates are `across` times the latter's; `swept` is what
// accelerations have beyond that.
struct State {
    std::map<std::string, Vector> lists;
    Vector q, v, tau, seconds, swept;
    Matrix across;
};

struct Robot {
    pin::Model model;
    pin::Data data;
    std::vector<std::string> names;
    std::string link;
    std::vector<State> states;

    void enter(State& state) {
        const Vector &q = state.lists["q"], &v = state.lists["v"];
        const Eigen::Index base = q.size() > v.size() ? 1 : 0;
        state.q = Vector::Zero(model.nq);
        state.across = Matrix::Zero(model.nv, model.nv);
        if (base) {
            const Eigen::Quaterniond turn(q[3], q[4], q[5], q[6]);
            state.q.head(3) = q.head(3);
            state.q.segment(3, 4) = turn.coeffs();
            state.across.topLeftCorner(3, 3) = turn.toRotationMatrix();
            state.across.block(3, 3, 3, 3).setIdentity();
        }
        for (size_t k = 0; k < names.size(); ++k) {
            const std::string name = names[k].substr(0, names[k].find('/'));
            const auto& own = model.joints[model.getJointId(name)];
            const Eigen::Index from = k + 7 * base, rate = k + 6 * base;
            if (own.nv() == 3) {  // two slides and a hinge
                if (name != names[k]) continue;
                const double c = std::cos(q[from]), s = std::sin(q[from]);
                state.q.segment(own.idx_q(), 4) << q[from - 2], q[from - 1], c, s;
                state.across.block(rate - 2, own.idx_v(), 3, 3) << c, -s, 0, s, c, 0, 0, 0, 1;
                continue;
            }
            state.across(rate, own.idx_v()) = 1.0;
            if (own.nq() == 2) {
                state.q.segment(own.idx_q(), 2) << std::cos(q[from]), std::sin(q[from]);
            } else {
                state.q[own.idx_q()] = q[from];
            }
        }
        const Matrix back = state.across.transpose();
        state.v = back * v;
        state.tau = back * state.lists["torques"];
        state.swept = Vector::Zero(model.nv);  // rates in turning axes change with these
        if (base) {
            const Eigen::Vector3d velocity = state.v.head(3), spin = state.v.segment(3, 3);
            state.swept.head(3) = spin.cross(velocity);
        }
        if (!base && model.joints[1].nv() == 3) state.swept.head(2) << -state.v[2] * state.v[1], state.v[2] * state.v[0];
        state.seconds = back * state.lists["seconds"] - state.swept;
    }

    Robot(const char* path, const char* numbers) : model(read(path)), data(model) {
        std::ifstream file(numbers);
        std::string line, key;
        std::map<std::string, size_t> met;
        while (std::getline(file, line)) {
            std::istringstream words(line);
            words >> key;
            if (key == "joints") {
                for (std::string name; words >> name;) names.push_back(name);
            } else if (key == "of") {
                words >> link;
            } else {
                std::vector<double> list;
                for (std::string word; words >> word;) list.push_back(std::stod(word));
                const size_t k = met[key]++;
                if (k >= states.size()) states.resize(k + 1);
                states[k].lists[key] = Eigen::Map<Vector>(list.data(), list.size());
            }
        }
        for (State& state : states) enter(state);
    }
};

// Nanoseconds a call: the median of batches that go through all states.
template <class Call>
static double clocked(const std::vector<State>& states, Call call) {
    using Clock = std::chrono::steady_clock;
    std::vector<double> times;
    const auto begin = Clock::now();
    while (times.size() < 5 || Clock::now() - begin < std::chrono::milliseconds(40)) {
        const auto start = Clock::now();
        for (int round = 0; round < 4; ++round)
            for (const State& state : states) {
                call(state);
                asm volatile("" ::: "memory");
            }
        times.push_back(std::chrono::duration<double, std::nano>(Clock::now() - start).count() / (4 * states.size()));
    }
    std::nth_element(times.begin(), times.begin() + times.size() / 2, times.end());
    return times[times.size() / 2];
}

static void time(Robot& robot) {
    const pin::Model& model = robot.model;
    pin::Data& data = robot.data;
    pin::Data::Matrix6x columns = pin::Data::Matrix6x::Zero(6, model.nv);
    const auto frame = model.getFrameId(robot.link);
    const auto print = [&](const char* name, auto call) { std::printf("%s %.2f\n", name, clocked(robot.states, call)); };
    using pin::Convention;
    print("aba_local", [&](const State& s) { pin::aba(model, data, s.q, s.v, s.tau, Convention::LOCAL); });
    print("aba_world", [&](const State& s) { pin::aba(model, data, s.q, s.v, s.tau, Convention::WORLD); });
    print("rnea", [&](const State& s) { pin::rnea(model, data, s.q, s.v, s.seconds); });
    print("crba_local", [&](const State& s) { pin::crba(model, data, s.q, Convention::LOCAL); });
    print("crba_world", [&](const State& s) { pin::crba(model, data, s.q, Convention::WORLD); });
    print("jacobian_frame", [&](const State& s) {
        pin::computeFrameJacobian(model, data, s.q, frame, pin::LOCAL_WORLD_ALIGNED, columns);
    });
    print("jacobian_joints", [&](const State& s) {
        pin::computeJointJacobians(model, data, s.q);
        pin::getFrameJacobian(model, data, frame, pin::LOCAL_WORLD_ALIGNED, columns);
    });
    print("aba_derivatives", [&](const State& s) { pin::computeABADerivatives(model, data, s.q, s.v, s.tau); });
}

static void check(Robot& robot) {
    const pin::Model& model = robot.model;
    pin::Data& data = robot.data;
    const Eigen::Index n = model.nv;
    const auto frame = model.getFrameId(robot.link);
    std::map<std::string, double> worst;
    for (State& state : robot.states) {
        const Matrix &t = state.across, back = t.transpose();
        const auto compare = [&](const char* name, const Matrix& expected, Eigen::Index from = 0) {
            const auto found = state.lists.find(name);
            if (found == state.lists.end()) return;
            const Matrix own = Eigen::Map<const Rows>(found->second.data() + from, expected.rows(), expected.cols());
            const double off = (own - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
            // A number that is none counts as wrong.
            double& most = worst[name];
            most = off <= most ? most : off;
        };
        const Vector second = t * (pin::aba(model, data, state.q, state.v, state.tau, pin::Convention::LOCAL) + state.swept);
        compare("sweep", second);
        compare("sweep", t * (pin::aba(model, data, state.q, state.v, state.tau, pin::Convention::WORLD) + state.swept));
        compare("forward_dynamics", second);
        compare("inverse_dynamics", t * pin::rnea(model, data, state.q, state.v, state.seconds));
        for (const auto convention : {pin::Convention::LOCAL, pin::Convention::WORLD}) {
            const Matrix half = pin::crba(model, data, state.q, convention);
            compare("mass_matrix", t * Matrix(half.selfadjointView<Eigen::Upper>()) * back);
        }
        pin::Data::Matrix6x columns = pin::Data::Matrix6x::Zero(6, n);
        pin::computeFrameJacobian(model, data, state.q, frame, pin::LOCAL_WORLD_ALIGNED, columns);
        compare("jacobian", t * columns.transpose());
        pin::computeABADerivatives(model, data, state.q, state.v, state.tau);
        // Of other coordinates than Pinocchio's, by torques alone.
        if (state.swept.isZero()) compare("forward_dynamics_derivatives", t * data.ddq_dq * back);
        if (state.swept.isZero()) compare("forward_dynamics_derivatives", t * data.ddq_dv * back, n * n);
        compare("forward_dynamics_derivatives", t * Matrix(data.Minv.selfadjointView<Eigen::Upper>()) * back, 2 * n * n);
    }
    for (const auto& [name, off] : worst) std::printf("%s %.1e\n", name.c_str(), off);
}

int main(int count, char** words) {
    if (count != 4) return 1;
    Robot robot(words[2], words[3]);
    if (std::string(words[1]) == "time") {
        time(robot);
    } else {
        check(robot);
    }
}
