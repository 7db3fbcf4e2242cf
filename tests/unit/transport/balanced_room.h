/// A room with its rows and a lit floor, ready to be balanced.
#pragma once

#include "engine/transport/balance.h"
#include "tests/unit/mesh/sample_scenes.h"

namespace hanei {

struct BalancedRoom {
    std::shared_ptr<const Mesh> mesh;
    DenseRows factors;
    Visibility visibility;
    std::vector<double> reflectance, direct, own;

    explicit BalancedRoom(const Scene& scene, double max_patch = 0.7) : mesh(make_mesh(scene, max_patch)) {
        std::vector<Receiver> centres;
        for (const Patch& patch : mesh->patches) centres.push_back(mesh->centre_of(patch));
        factors = *patch_factors(*mesh, centres, {2});
        visibility = *patch_visibility(*mesh, centres, occluders_of(scene), {2});
        const PerPatch<double> of_scene = reflectances(*mesh, scene);
        reflectance.assign(of_scene.all().begin(), of_scene.all().end());
        direct.assign(mesh->patches.size(), 0.0);
        own.assign(mesh->patches.size(), 0.0);
        for (std::size_t k = 0; k < direct.size(); ++k) {
            const Vec3& centre = mesh->patches[k].centre;
            direct[k] = centre.z < 0.1 ? 300.0 + 50.0 * centre.x : 0.0;  // the floor is lit, the ceiling dark
        }
    }
    std::size_t size() const { return direct.size(); }
    BalanceInput input() const { return {&factors, &visibility, reflectance, direct, own}; }
    Exchange exchange(const Work& work = {2}) const { return exchange_by(factors, &visibility, work); }
};

}  // namespace hanei
