#include "render/scene/ogre/DayShapesPart.h"

#include <algorithm>
#include <utility>

#include "render/scene/light/DayShapes.h"
#include "render/scene/ogre/Axes.h"

namespace sagara::render {

DayShapesPart::DayShapesPart(const PartContext& context, const ShaderMaterial& solid)
    : m_material(solid.ogre()->getName()), m_object(context.scenes.createManualObject()) {
    m_object->setDynamic(true);
    m_object->setRenderQueueGroup(kSolidQueue);
    context.scenes.getRootSceneNode()->createChildSceneNode()->attachObject(m_object);
    for (const ShipLook& ship : context.fleet.own) m_own.push_back(ship.form);
    for (const ShipLook& target : context.fleet.targets) m_targets.push_back(target.form);
}

void DayShapesPart::add(const ShipForm& form, const ShipPose& pose, std::optional<std::size_t> own) {
    const DayHoist hoist = dayHoistOf(form, pose.activity);
    if (hoist.shapes.empty()) return;
    const DayShape& lowest = hoist.shapes.back();
    const Point at = lowest.centre;
    const bool abaft = at.x < form.bridge_m + 1.0;
    m_hoists.push_back({pointOnShip(pose, at.x, at.y, at.up), solidOf(hoist), lowest.diameter_m,
                        abaft ? own : std::nullopt});
}

void DayShapesPart::join(const Fleet& fleet, std::size_t fromTarget) {
    m_targets.resize(fromTarget);
    for (std::size_t i = fromTarget; i < fleet.targets.size(); ++i)
        m_targets.push_back(fleet.targets[i].form);
}

void DayShapesPart::advance(const Frame& frame) {
    m_hoists.clear();
    for (std::size_t i = 0; i < std::min(m_own.size(), frame.moment.ships.size()); ++i)
        add(m_own[i], frame.moment.ships[i], i);
    for (const TargetPose& target : frame.moment.targets)
        if (target.index < m_targets.size()) add(m_targets[target.index], target, std::nullopt);
}

bool DayShapesPart::isSeen(const Hoist& hoist, const View& view) const {
    constexpr double kLeast_px = 0.4;
    if (hoist.abaftBridgeOf && view.camera.inside == hoist.abaftBridgeOf) return false;
    const double pixel = (view.camera.lens.right - view.camera.lens.left) / view.width;
    return hoist.size_m > kLeast_px * pixel * core::distance(view.camera.position, hoist.place.position);
}

void DayShapesPart::look(const Frame&, const View& view) {
    const bool any = std::any_of(m_hoists.begin(), m_hoists.end(),
                                 [&](const Hoist& hoist) { return isSeen(hoist, view); });
    m_object->setVisible(any);
    if (!any) return;
    if (!std::exchange(m_begun, true))
        m_object->begin(m_material, Ogre::RenderOperation::OT_TRIANGLE_LIST, kSceneGroup);
    else
        m_object->beginUpdate(0);
    std::uint32_t first = 0;
    for (const Hoist& hoist : m_hoists) {
        if (!isSeen(hoist, view)) continue;
        const Ogre::Vector3 place = relativeTo(view.camera, hoist.place.position, hoist.place.up_m);
        for (const SolidVertex& v : hoist.shape.vertices) {
            m_object->position(place + ogreFromNed(v.position.x, v.position.y, -v.position.up));
            m_object->normal(ogreFromNed(v.normal.x, v.normal.y, -v.normal.up));
            m_object->colour(static_cast<float>(v.colour.red), static_cast<float>(v.colour.green),
                             static_cast<float>(v.colour.blue), 1.0f);
        }
        for (const std::uint32_t i : hoist.shape.indices) m_object->index(first + i);
        first += static_cast<std::uint32_t>(hoist.shape.vertices.size());
    }
    m_object->end();
    m_object->setBoundingBox(Ogre::AxisAlignedBox::BOX_INFINITE);
}

}  // namespace sagara::render
