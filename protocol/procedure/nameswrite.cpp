// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedure/nameswrite.h"

#include "protocol/device/abilities.h"
#include "protocol/device/device.h"

using namespace Qt::StringLiterals;

NamesWrite::NamesWrite(Channel &channel, Device &device, const Configuration &base,
                       const Configuration &edited)
    : m_channel(channel)
    , m_device(device)
    , m_base(base)
    , m_edited(edited)
    , m_isWanted(base.hasOtherNames(edited))
{
}

Result<void> NamesWrite::check(QStringList &conflicts) const
{
    if (!m_isWanted)
        return {};
    ProfileAccess *profiles = m_device.profiles();
    if (!profiles)
        return failure(ErrorCode::Unsupported, u"this board has one profile, without a name"_s);
    if (m_base.findMissing({0, MissingPart::kProfileNames}))
        return failure(ErrorCode::Incomplete,
                       u"profile names; the board takes all of them at once, so those that were not read "
                       "would be erased: nothing was written"_s);
    const auto now = profiles->readProfileNames(m_channel);
    if (!now)
        return tl::unexpected(now.error());
    for (int profile = 0; profile < m_base.identity().profileCount; ++profile) {
        const QString name = now->value(profile);
        if (name != m_base.profileNames().value(profile) && name != m_edited.profileNames().value(profile))
            conflicts.append(u"name of profile %1: read as '%2', now '%3'"_s.arg(profile + 1)
                                 .arg(m_base.profileNames().value(profile), name));
    }
    return {};
}

Result<void> NamesWrite::write(WriteReport &report)
{
    if (!m_isWanted)
        return {};
    ProfileAccess *profiles = m_device.profiles();
    // Until they are read back, it is unknown which the board holds.
    m_isSent = true;
    report.namesState = WriteState::Unknown;
    if (const auto written = profiles->writeProfileNames(m_channel, m_edited.profileNames()); !written)
        return written;
    const auto again = profiles->readProfileNames(m_channel);
    if (!again)
        return tl::unexpected(again.error());
    report.learnNames(*again, WriteState::Mismatch);
    if (report.namesState != WriteState::Verified)
        return failure(ErrorCode::VerifyFailed, u"profile names: "_s + again->join(u", "_s));
    return {};
}

void NamesWrite::undo(WriteReport &report)
{
    if (!m_isSent)
        return;
    ProfileAccess *profiles = m_device.profiles();
    // Perhaps only an answer was lost, perhaps the board has not taken them.
    const auto sent = profiles->readProfileNames(m_channel);
    Configuration taken = m_base;
    if (sent)
        taken.setProfileNames(*sent);
    const bool wasTaken = sent && m_base.hasOtherNames(taken);
    const WriteState kept
        = report.namesState == WriteState::Mismatch ? WriteState::Mismatch : WriteState::NotWritten;
    const bool isBack = profiles->writeProfileNames(m_channel, m_base.profileNames()).has_value();
    const auto now = profiles->readProfileNames(m_channel);
    if (now)
        report.learnNames(*now, wasTaken || (!sent && isBack) ? WriteState::RolledBack : kept);
    else
        report.namesState = WriteState::Unknown;
}
