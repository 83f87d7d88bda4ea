// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/mavlink/messages.h"

#include <algorithm>
#include <array>

namespace mavlink {

namespace {

// Wire order: the longest fields first (errata 6).
constexpr Field kHeartbeat[] = {
    {"custom_mode", Field::U32, 0, 4}, {"type", Field::U8, 4},          {"autopilot", Field::U8, 5},
    {"base_mode", Field::U8, 6},       {"system_status", Field::U8, 7}, {"mavlink_version", Field::U8, 8},
};
constexpr Field kParamRequestRead[] = {
    {"param_index", Field::I16, 0, 2},
    {"target_system", Field::U8, 2},
    {"target_component", Field::U8, 3},
    {"param_id", Field::Text, 4, 16},
};
constexpr Field kTarget[] = {{"target_system", Field::U8, 0}, {"target_component", Field::U8, 1}};
constexpr Field kParamValue[] = {
    {"param_value", Field::F32, 0, 4}, {"param_count", Field::U16, 4, 2}, {"param_index", Field::U16, 6, 2},
    {"param_id", Field::Text, 8, 16},  {"param_type", Field::U8, 24},
};
constexpr Field kParamSet[] = {
    {"param_value", Field::F32, 0, 4}, {"target_system", Field::U8, 4}, {"target_component", Field::U8, 5},
    {"param_id", Field::Text, 6, 16},  {"param_type", Field::U8, 22},
};
constexpr Field kAttitude[] = {
    {"time_boot_ms", Field::U32, 0, 4}, {"roll", Field::F32, 4, 4},       {"pitch", Field::F32, 8, 4},
    {"yaw", Field::F32, 12, 4},         {"rollspeed", Field::F32, 16, 4}, {"pitchspeed", Field::F32, 20, 4},
    {"yawspeed", Field::F32, 24, 4},
};
// clang-format off
constexpr Field kCommandLong[] = {
    {"param1", Field::F32, 0, 4}, {"param2", Field::F32, 4, 4}, {"param3", Field::F32, 8, 4}, {"param4", Field::F32, 12, 4},
    {"param5", Field::F32, 16, 4}, {"param6", Field::F32, 20, 4}, {"param7", Field::F32, 24, 4}, {"command", Field::U16, 28, 2},
    {"target_system", Field::U8, 30}, {"target_component", Field::U8, 31}, {"confirmation", Field::U8, 32},
};
// clang-format on
constexpr Field kCommandAck[] = {{"command", Field::U16, 0, 2}, {"result", Field::U8, 2}};
// clang-format off
constexpr Field kDigicamControl[] = {
    {"extra_value", Field::F32, 0, 4}, {"target_system", Field::U8, 4}, {"target_component", Field::U8, 5},
    {"session", Field::U8, 6}, {"zoom_pos", Field::U8, 7}, {"zoom_step", Field::I8, 8}, {"focus_lock", Field::U8, 9},
    {"shot", Field::U8, 10}, {"command_id", Field::U8, 11}, {"extra_param", Field::U8, 12},
};
// clang-format on
constexpr Field kMountConfigure[] = {
    {"target_system", Field::U8, 0}, {"target_component", Field::U8, 1}, {"mount_mode", Field::U8, 2},
    {"stab_roll", Field::U8, 3},     {"stab_pitch", Field::U8, 4},       {"stab_yaw", Field::U8, 5},
};
constexpr Field kMountControl[] = {
    {"input_a", Field::I32, 0, 4},    {"input_b", Field::I32, 4, 4},       {"input_c", Field::I32, 8, 4},
    {"target_system", Field::U8, 12}, {"target_component", Field::U8, 13}, {"save_position", Field::U8, 14},
};
constexpr Field kTargetSpecific[] = {
    {"target_system", Field::U8, 0},
    {"target_component", Field::U8, 1},
    {"specific_payload", Field::Bytes, 2, 0},
};
constexpr Field kParamRead2[] = {
    {"param_index", Field::U16, 0, 2},
    {"target_system", Field::U8, 2},
    {"target_component", Field::U8, 3},
};
constexpr Field kParamSet2[] = {
    {"param_value", Field::F32, 0, 4},  {"param_index", Field::U16, 4, 2}, {"target_system", Field::U8, 6},
    {"target_component", Field::U8, 7}, {"param_type", Field::U8, 8},
};
constexpr Field kParamValue2[] = {
    {"param_value", Field::F32, 0, 4}, {"param_index", Field::U16, 4, 2},  {"param_count", Field::U16, 6, 2},
    {"target_system", Field::U8, 8},   {"target_component", Field::U8, 9}, {"param_type", Field::U8, 10},
};
constexpr Field kStatusText[] = {{"severity", Field::U8, 0}, {"text", Field::Text, 1, 50}};

// clang-format off
constexpr Message kMessages[] = {
    {MessageId::Heartbeat, "HEARTBEAT", 50, 9, false, kHeartbeat},
    {MessageId::ParamRequestRead, "PARAM_REQUEST_READ", 214, 20, false, kParamRequestRead},
    {MessageId::ParamRequestList, "PARAM_REQUEST_LIST", 159, 2, false, kTarget},
    {MessageId::ParamValue, "PARAM_VALUE", 220, 25, false, kParamValue},
    {MessageId::ParamSet, "PARAM_SET", 168, 23, false, kParamSet},
    {MessageId::Attitude, "ATTITUDE", 39, 28, false, kAttitude},
    {MessageId::CommandLong, "COMMAND_LONG", 152, 33, false, kCommandLong},
    {MessageId::CommandAck, "COMMAND_ACK", 143, 3, false, kCommandAck},
    {MessageId::DigicamControl, "DIGICAM_CONTROL", 22, 13, false, kDigicamControl},
    {MessageId::MountConfigure, "MOUNT_CONFIGURE", 19, 6, false, kMountConfigure},
    {MessageId::MountControl, "MOUNT_CONTROL", 21, 15, false, kMountControl},
    {MessageId::TargetSpecific, "COMMAND_TARGET_SPECIFIC", 152, 2, true, kTargetSpecific},
    {MessageId::TargetSpecificAck, "COMMAND_TARGET_SPECIFIC_ACK", 102, 2, true, kTargetSpecific},
    {MessageId::ParamRead2, "PARAM_READ2", 195, 4, false, kParamRead2},
    {MessageId::ParamSet2, "PARAM_SET2", 49, 9, false, kParamSet2},
    {MessageId::ParamValue2, "PARAM_VALUE2", 78, 11, false, kParamValue2},
    {MessageId::StatusText, "STATUSTEXT", 83, 51, false, kStatusText},
};
// clang-format on

// The fields of each message are contiguous and fill it.
constexpr bool fieldsFill(const Message &message)
{
    int at = 0;
    for (const Field &field : message.fields) {
        if (field.offset != at)
            return false;
        at += field.size;
    }
    return at == message.size;
}
static_assert(std::all_of(std::begin(kMessages), std::end(kMessages), fieldsFill));

}  // namespace

std::span<const Message> messages()
{
    return kMessages;
}

const Message *findMessage(int id)
{
    const auto it = std::find_if(std::begin(kMessages), std::end(kMessages),
                                 [id](const Message &message) { return number(message.id) == id; });
    return it == std::end(kMessages) ? nullptr : it;
}

const Message *findMessage(const QString &name)
{
    const auto it = std::find_if(std::begin(kMessages), std::end(kMessages), [&name](const Message &message) {
        return name == QLatin1String(message.name);
    });
    return it == std::end(kMessages) ? nullptr : it;
}

QString commandName(int command)
{
    struct Named
    {
        int id;
        const char *name;
    };
    // clang-format off
    static constexpr std::array<Named, 9> kNames{{
        {180, "DO_SET_PARAMETER"}, {183, "DO_SET_SERVO"}, {203, "DO_DIGICAM_CONTROL"}, {204, "DO_MOUNT_CONFIGURE"},
        {205, "DO_MOUNT_CONTROL"}, {220, "DO_MOUNT_CONTROL_QUAT"}, {245, "PREFLIGHT_STORAGE"}, {1234, "REQUEST_ATTITUDE"},
        {1235, "TARGET_SPECIFIC"},
    }};
    // clang-format on
    const auto it = std::find_if(kNames.begin(), kNames.end(),
                                 [command](const Named &named) { return named.id == command; });
    return it == kNames.end() ? QString::number(command) : QString::fromLatin1(it->name);
}

}  // namespace mavlink
