// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/missingtext.h"

#include <QCoreApplication>

#include <map>
#include <set>

using namespace Qt::StringLiterals;

namespace {

struct MissingText
{
    Q_DECLARE_TR_FUNCTIONS(MissingText)
};

}  // namespace

QString missingText(const Configuration &configuration, const std::vector<MissingPart> &parts)
{
    std::map<int, std::set<int>> profilesOfBlocks;
    bool isNames = false;
    for (const MissingPart &part : parts) {
        if (part.key.block == MissingPart::kProfileNames)
            isNames = true;
        else
            profilesOfBlocks[part.key.block].insert(part.key.profile);
    }
    QStringList texts;
    for (const auto &[block, profiles] : profilesOfBlocks) {
        const QString name = configuration.blockName(block);
        const int count = configuration.identity().profileCount;
        QStringList numbers;
        for (const int profile : profiles)
            numbers.append(QString::number(profile + 1));
        if (count <= 1)
            texts.append(name);
        else if (int(profiles.size()) == count)
            texts.append(MissingText::tr("%1 of all profiles").arg(name));
        else if (profiles.size() == 1)
            texts.append(MissingText::tr("%1 of profile %2").arg(name, numbers.first()));
        else
            texts.append(MissingText::tr("%1 of profiles %2").arg(name, numbers.join(u", "_s)));
    }
    if (isNames)
        texts.append(MissingText::tr("profile names"));
    return texts.join(u", "_s);
}
