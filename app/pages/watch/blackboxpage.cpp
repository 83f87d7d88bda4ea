// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/watch/blackboxpage.h"

#include "protocol/base/filefault.h"
#include "protocol/client/whendone.h"
#include "widgets/models/numbertext.h"
#include "widgets/theme/tablelook.h"

#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QShortcut>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace {

constexpr qint64 kLargestBox = 1 << 30;
constexpr int kFilterWidth = 220;
constexpr int kValueWidth = 170;
constexpr int kChangedBar = 3;

/// A changed value is bold and has a bar at its edge; one that was not written there is pale.
class WrittenDelegate final : public QStyledItemDelegate
{
public:
    WrittenDelegate(const Theme &theme, QObject *parent)
        : QStyledItemDelegate(parent)
        , m_theme(theme)
    {
    }

    void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override
    {
        QStyledItemDelegate::paint(painter, option, index);
        if (index.data(BlackBoxModel::ChangedRole).toBool())
            painter->fillRect(
                QRect(option.rect.left(), option.rect.top() + 1, kChangedBar, option.rect.height() - 2),
                m_theme.color(ColorRole::Changed));
    }

protected:
    void initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        if (index.column() == BlackBoxModel::kTimeColumn)
            return;
        option->font.setBold(index.data(BlackBoxModel::ChangedRole).toBool());
        if (!index.data(BlackBoxModel::WrittenRole).toBool())
            option->palette.setColor(QPalette::Text, m_theme.color(ColorRole::Muted));
    }

private:
    const Theme &m_theme;
};

}  // namespace

BlackBoxPage::BlackBoxPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"blackbox"_s, tr("Black box"), parent)
    , m_table(new QTableView)
    , m_filter(new QLineEdit)
    , m_next(new QPushButton(tr("Next change")))
    , m_found(new QLabel)
{
    m_filter->setPlaceholderText(tr("Names (Ctrl+F)"));
    m_filter->setAccessibleName(tr("Show only names that hold these words"));
    m_filter->setClearButtonEnabled(true);
    m_filter->setFixedWidth(kFilterWidth);
    m_next->setToolTip(tr("To the next changed value of the chosen column (F3)"));
    header()->addWidget(m_filter);
    header()->addWidget(m_next);
    m_table->setModel(&m_model);
    m_table->setAccessibleName(tr("Lines of the black box"));
    m_table->setItemDelegate(new WrittenDelegate(workspace.theme(), m_table));
    setPlainRows(*m_table);
    m_table->setAlternatingRowColors(true);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setWordWrap(false);
    m_table->horizontalHeader()->setDefaultSectionSize(kValueWidth);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_found->setObjectName(u"muted"_s);
    m_found->setWordWrap(true);
    body()->addWidget(m_found);
    body()->addWidget(m_table, 1);
    connect(m_filter, &QLineEdit::textChanged, &m_model, &BlackBoxModel::setFilter);
    connect(m_next, &QPushButton::clicked, this, &BlackBoxPage::goToNextChange);
    new QShortcut(Qt::Key_F3, this, [this] { goToNextChange(); });
    new QShortcut(QKeySequence::Find, this, [this] { m_filter->setFocus(); });
    connect(&workspace.client(), &DeviceClient::stateChanged, this, [this] {
        if (isVisible())
            read();
    });
    showBox(nullptr);
}

void BlackBoxPage::showEvent(QShowEvent *event)
{
    Page::showEvent(event);
    read();
}

void BlackBoxPage::read()
{
    const DeviceClient &client = workspace().client();
    const QString path = client.address().target();
    if (!client.isConnected() || !client.address().isReplay() || path == m_path)
        return;
    m_path = path;
    m_found->setText(tr("Reading…"));
    using Box = std::shared_ptr<const BlackBox>;
    whenDone(workspace().client().submit<Box>([path](Channel &, Device &) -> Result<Box> {
        const auto bytes = readWhole(path, FileKind::Recording, kLargestBox);
        if (!bytes)
            return tl::unexpected(bytes.error());
        auto box = BlackBox::read(*bytes);
        if (!box)
            return tl::unexpected(inFile(box.error(), path));
        return std::make_shared<const BlackBox>(*std::move(box));
    }),
             this, [this](const Result<Box> &box) {
                 showBox(box.value_or(nullptr));
                 if (!box)
                     m_path.clear();
                 if (!box && !isEndOfLink(box.error()))
                     workspace().notifications().report(box.error(), Concern::Loading);
             });
}

void BlackBoxPage::showBox(std::shared_ptr<const BlackBox> box)
{
    m_next->setEnabled(box != nullptr);
    if (!box) {
        m_found->setText(tr("Open the black box of a drone to see its lines."));
    } else {
        const double seconds = double(box->lines().back().at - box->lines().front().at) * 1e-6;
        QString text = tr("%n line(s)", nullptr, int(box->lines().size())) + u" · "_s
            + tr("%n name(s)", nullptr, int(box->names().size())) + u" · "_s
            + tr("%1 s. Values that differ from the line before are bold.").arg(numberText(seconds, 1));
        if (!box->damage().empty())
            text += u' '
                + tr("%n place(s) of the file could not be read.", nullptr, int(box->damage().size()));
        m_found->setText(text);
    }
    m_model.setBox(std::move(box));
}

void BlackBoxPage::goToNextChange()
{
    const QModelIndex current = m_table->currentIndex();
    const int column = current.isValid() ? current.column() : BlackBoxModel::kTimeColumn;
    int row = m_model.nextChange(current.isValid() ? current.row() : -1, column);
    if (row < 0)
        row = m_model.nextChange(-1, column);  // over the end
    if (row >= 0)
        m_table->setCurrentIndex(m_model.index(row, column));
}
