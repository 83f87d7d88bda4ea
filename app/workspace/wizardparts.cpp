// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/wizardparts.h"

#include "widgets/forms/keyboard.h"
#include "widgets/views/sensorcube.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

using namespace Qt::StringLiterals;

namespace {

constexpr int kPictureHeight = 190;

}  // namespace

QString faceName(int face)
{
    switch (face) {
    case 0: return FaceList::tr("Z up");
    case 1: return FaceList::tr("Z down");
    case 2: return FaceList::tr("X up");
    case 3: return FaceList::tr("X down");
    case 4: return FaceList::tr("Y up");
    case 5: return FaceList::tr("Y down");
    default: return FaceList::tr("tilted");
    }
}

void setHeadline(QLabel &label)
{
    QFont font = label.font();
    font.setPointSizeF(font.pointSizeF() + 2);
    font.setWeight(QFont::DemiBold);
    label.setFont(font);
    label.setWordWrap(true);
}

void setQuiet(QProgressBar &bar, const QString &accessibleName)
{
    bar.setRange(0, 100);
    bar.setTextVisible(false);
    bar.setAccessibleName(accessibleName);
}

QPushButton *addMethod(QBoxLayout &row, const Theme &theme, const QString &title, const QString &text,
                       const QString &button, int face)
{
    auto *card = new Card(title);
    auto *picture = new SensorCube(theme);
    picture->setPosition(face);
    picture->setFixedHeight(kPictureHeight);
    auto *label = new QLabel(text);
    label->setWordWrap(true);
    label->setAlignment(Qt::AlignTop);
    auto *go = new QPushButton(button);
    go->setObjectName(u"primary"_s);
    setHarmless(*go);  // it leads to the first step
    card->content()->addWidget(picture);
    card->content()->addWidget(label, 1);
    card->content()->addWidget(go);
    row.addWidget(card, 1);
    return go;
}

FaceList::FaceList(QWidget *parent)
    : QListWidget(parent)
{
    setAccessibleName(tr("Faces"));
    setMaximumWidth(200);
    setFocusPolicy(Qt::NoFocus);
    setSelectionMode(QAbstractItemView::NoSelection);
    for (int face = 0; face < kSensorFaces; ++face)
        addItem(QString());
    setDone(0);
}

void FaceList::setDone(unsigned done)
{
    for (int face = 0; face < kSensorFaces; ++face)
        item(face)->setText((done >> face & 1U ? u"✓  "_s : u"○  "_s) + faceName(face));
}

SimulatedHands::SimulatedHands(Workspace &workspace, const Places &places, QWidget *parent,
                               const QString &title)
    : Card(title.isEmpty() ? tr("Simulated gimbal: your hands") : title, parent)
    , m_workspace(workspace)
{
    if (!places.isEmpty())
        add(u"pose"_s, tr("Where the simulated camera is"), places);
    const auto update = [this] { setVisible(m_workspace.isSimulated()); };
    connect(&workspace.client(), &DeviceClient::stateChanged, this, update);
    update();
}

SimulatedHands::SimulatedHands(Workspace &workspace, QWidget *parent)
    : SimulatedHands(workspace, {}, parent)
{
}

void SimulatedHands::add(const QString &what, const QString &accessibleName, const Places &places, int now)
{
    auto *box = new QComboBox;
    box->setAccessibleName(accessibleName);
    box->setMaximumWidth(Metric::kFieldWidth);
    for (const auto &[name, number] : places)
        box->addItem(name, number);
    box->setPlaceholderText(accessibleName);
    box->setCurrentIndex(box->findData(now));
    content()->addWidget(box);
    connect(box, &QComboBox::activated, this,
            [this, what, box] { m_workspace.changeWorld(what + u'=' + box->currentData().toString()); });
    connect(&m_workspace, &Workspace::worldChanged, this, [what, box](const QString &assignment) {
        if (assignment.startsWith(what + u'='))
            box->setCurrentIndex(box->findData(assignment.mid(what.size() + 1).toInt()));
    });
}

SimulatedHands::Places::value_type SimulatedHands::inGimbal()
{
    return {tr("in the gimbal, in your hand"), 0};
}

SimulatedHands::Places SimulatedHands::faces()
{
    Places places{inGimbal()};
    for (int face = 0; face < kSensorFaces; ++face)
        places.append({tr("lies still: %1").arg(faceName(face)), face + 1});
    return places;
}

void SimulatedHands::putBack()
{
    if (m_workspace.isSimulated())
        m_workspace.changeWorld(u"pose=0"_s);
}
