#include "viz/state/state.h"

#include <nlohmann/json.hpp>

namespace rt::viz
{

namespace
{

using OrderedJson = nlohmann::ordered_json;

/// What is not finite is written as null.
OrderedJson triple(const Vec3<double>& v)
{
    return {v.x, v.y, v.z};
}

OrderedJson eventJson(const Controller& controller)
{
    const auto* event = controller.current();
    if (!event) return nullptr;
    return {{"text", describe(controller.tree(), *event)}, {"node", event->node}, {"line", event->line}};
}

OrderedJson comparisonJson(const Controller& controller)
{
    const auto* comparison = controller.comparison();
    if (!comparison) return nullptr;
    OrderedJson first = nullptr;
    if (const auto& found = comparison->first)
    {
        first = {{"path", found->path},        {"field", found->field},   {"expected", found->expected},
                 {"got", found->got},          {"angle", nullptr},        {"expected_node", found->expectedNode},
                 {"got_node", found->gotNode}, {"text", describe(*found)}};
        if (found->angle) first["angle"] = *found->angle;
    }
    return {{"with", controller.other().title}, {"nodes", comparison->tree.nodes.size()}, {"first_difference", first}};
}

} // namespace

std::string stateJson(const Controller& controller)
{
    const auto& tree = controller.tree();
    OrderedJson shown = OrderedJson::array();
    for (const auto& node : tree.nodes)
        if (controller.isReached(node.id) && controller.isShown(node.id)) shown.push_back(node.id);
    OrderedJson kindsShown;
    for (int kind = 0; kind < kinds; ++kind) kindsShown[name(Kind(kind))] = controller.shows(Kind(kind));
    const OrderedJson state = {
        {"source", controller.source().title},
        {"scene", controller.scene().file},
        {"pixel", controller.pixel() ? OrderedJson(*controller.pixel()) : OrderedJson(nullptr)},
        {"samples", controller.samples()},
        {"max_depth", controller.maxDepth()},
        {"painted", controller.painted()},
        {"nodes", tree.nodes.size()},
        {"radiance", tree.nodes.empty() ? OrderedJson(nullptr) : triple(tree.nodes[0].radiance)},
        {"selected", controller.node() ? OrderedJson(controller.selected()) : OrderedJson(nullptr)},
        {"hovered", controller.hovered() < 0 ? OrderedJson(nullptr) : OrderedJson(controller.hovered())},
        {"step", controller.step()},
        {"last_step", controller.lastStep()},
        {"event", eventJson(controller)},
        {"playing", controller.isPlaying()},
        {"speed", controller.speed()},
        {"shown_nodes", shown},
        {"kinds", kindsShown},
        {"weakest", controller.weakest()},
        {"normals", controller.showsNormals()},
        {"help", controller.showsHelp()},
        {"look", name(controller.look())},
        {"comparison", comparisonJson(controller)},
        {"message", controller.message()},
        {"tone", controller.message().empty() ? OrderedJson(nullptr) : OrderedJson(name(controller.tone()))}};
    return state.dump(1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

} // namespace rt::viz
