// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/blackbox/table.h"

#include <algorithm>
#include <array>
#include <list>
#include <mutex>

namespace blackbox {

namespace {

/// What the drone's program writes under a name of three numbers.
struct KnownName
{
    const char *name;
    std::array<const char *, 3> roles;
    const char *unit;
};
constexpr KnownName kKnown[] = {
    {"IMU:rate", {"rate.roll", "rate.pitch", "rate.yaw"}, "°/s"},
    {"IMU:gyroscope", {"", "", ""}, "°/s"},
    {"IMU:acceleration", {"acceleration.x", "acceleration.y", "acceleration.z"}, "m/s²"},
    {"IMU:accelerometer", {"acceleration.x", "acceleration.y", "acceleration.z"}, "m/s²"},
    {"IMU:rpy", {"attitude.roll", "attitude.pitch", "attitude.yaw"}, "°"},
    {"IMU:RPY", {"attitude.roll", "attitude.pitch", "attitude.yaw"}, "°"},
};
constexpr std::array<const char *, 3> kRates{"rate.roll", "rate.pitch", "rate.yaw"};
constexpr std::array kLetters{"x", "y", "z"};
constexpr std::array kThreeAxes{Axis::Roll, Axis::Pitch, Axis::Yaw};
constexpr int kDecimals = 4;

class Builder
{
public:
    explicit Builder(const std::vector<blackboxwire::Name> &names)
    {
        // Where the filtered rate was not written, the gyroscope's is what there is.
        m_hasRate = std::any_of(names.begin(), names.end(), [](const auto &each) {
            return each.name == "IMU:rate" && each.elements == 3;
        });
        for (const blackboxwire::Name &name : names)
            add(name);
    }
    [[nodiscard]] Table take() { return std::move(m_table); }

private:
    const char *keep(QByteArray word)
    {
        m_table.words.push_back(std::move(word));
        return m_table.words.back().constData();
    }

    void add(const blackboxwire::Name &name)
    {
        Table::Columns &columns = m_table.columns[name.name];
        const qsizetype colon = name.name.indexOf(':');
        const char *group = colon > 0 ? keep(name.name.first(colon)) : "Black box";
        const QByteArray own = name.name.sliced(colon + 1);
        const bool isTriple = name.elements == 3;
        const auto known = std::find_if(std::begin(kKnown), std::end(kKnown),
                                        [&name](const KnownName &each) { return name.name == each.name; });
        for (int i = 0; i < name.elements; ++i) {
            const QByteArray suffix
                = isTriple ? QByteArray(kLetters[std::size_t(i)]) : QByteArray::number(i + 1);
            ChannelSpec spec;
            spec.key = keep(name.elements == 1 ? name.name : name.name + '.' + suffix);
            spec.label = keep(name.elements == 1 ? own : own + ' ' + suffix);
            spec.group = group;
            spec.decimals = kDecimals;
            spec.axis = isTriple ? kThreeAxes[std::size_t(i)] : Axis::None;
            spec.min = -1;
            spec.max = 1;
            if (isTriple && known != std::end(kKnown)) {
                spec.unit = known->unit;
                spec.role = !m_hasRate && name.name == "IMU:gyroscope" ? kRates[std::size_t(i)]
                                                                       : known->roles[std::size_t(i)];
            }
            columns.channels.append(int(m_table.channels.size()));
            m_table.channels.push_back(spec);
        }
    }

    Table m_table;
    bool m_hasRate = false;
};

}  // namespace

const Table::Columns *Table::find(QByteArrayView name) const
{
    const auto found = columns.find(name.toByteArray());
    return found == columns.end() ? nullptr : &found->second;
}

const Table &tableOf(const std::vector<blackboxwire::Name> &names)
{
    struct Made
    {
        std::vector<blackboxwire::Name> names;
        Table table;
    };
    static std::list<Made> made;
    static std::mutex mutex;
    const std::lock_guard lock(mutex);
    const auto known
        = std::find_if(made.begin(), made.end(), [&names](const Made &each) { return each.names == names; });
    if (known != made.end())
        return known->table;
    made.push_back({names, Builder(names).take()});
    return made.back().table;
}

}  // namespace blackbox
