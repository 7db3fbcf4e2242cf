/// How far a long computation is, and the wish that it stop. One writer, any number of readers.
#pragma once

#include <atomic>
#include <stop_token>

namespace hanei {

/// The stages of a study, in the order light goes through the house.
enum class Stage { idle, planning, meshing, direct, factors, balance, gathering, refining, done };

class Progress {
public:
    void enter(Stage stage) {
        fraction_ = 0.0F;
        stage_ = stage;
    }
    void advance(float fraction) { fraction_ = fraction; }
    Stage stage() const { return stage_; }
    float fraction() const { return fraction_; }  ///< of the present stage, 0 to 1

private:
    std::atomic<Stage> stage_ = Stage::idle;
    std::atomic<float> fraction_ = 0.0F;
};

/// What every long computation is given: how many threads it may use, whether it shall stop, and
/// where it says how far it is. Being stopped is a return value (empty), not an error.
struct Work {
    int threads = 1;
    std::stop_token stop = {};
    Progress* progress = nullptr;  ///< may be null
};

}  // namespace hanei
