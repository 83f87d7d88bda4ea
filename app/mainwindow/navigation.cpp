// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/navigation.h"

#include "app/mainwindow/pagetable.h"

#include <QStyledItemDelegate>

#include <utility>

using namespace Qt::StringLiterals;

namespace {

constexpr int kKeyRole = Qt::UserRole;
constexpr int kTitleRole = Qt::UserRole + 1;
constexpr int kMarkRole = Qt::UserRole + 2;
constexpr int kIcon = 18;
const QString kMark = u" •"_s;
constexpr int kLastNumber = 9;  // Ctrl+1 to Ctrl+9

/// Entries look alike whether the list can be used or not: the style of what is disabled is the headings',
/// and stands otherwise.
class EntryDelegate final : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        if (index.flags() & Qt::ItemIsEnabled)
            option->state |= QStyle::State_Enabled;
    }
};

}  // namespace

Navigation::Navigation(QWidget *parent)
    : QListWidget(parent)
{
    setObjectName(u"navigation"_s);
    setAccessibleName(tr("Pages"));
    setIconSize({kIcon, kIcon});
    setItemDelegate(new EntryDelegate(this));
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    QString group;
    for (const PageEntry &entry : pageTable()) {
        if (group != QLatin1String(entry.group)) {
            group = QLatin1String(entry.group);
            auto *heading = new QListWidgetItem(pageText(entry.group).toUpper(), this);
            heading->setFlags(Qt::NoItemFlags);
            QFont font = heading->font();
            font.setPointSizeF(font.pointSizeF() - 1.5);
            font.setWeight(QFont::DemiBold);
            heading->setFont(font);
        }
        const QString title = pageText(entry.title);
        auto *item
            = new QListWidgetItem(QIcon(u":/icons/%1.svg"_s.arg(QLatin1String(entry.key))), title, this);
        item->setData(kKeyRole, QString::fromLatin1(entry.key));
        item->setData(kTitleRole, title);
    }
    renumber();
    constexpr int kRoom = 26;  // of the scroll bar, and of a mark
    setFixedWidth(std::max(168, sizeHintForColumn(0) + kRoom));
    connect(this, &QListWidget::currentItemChanged, this, [this] {
        m_awaited.clear();
        if (isOffered(currentPage()))
            emit pageChosen(currentPage());
    });
}

QString Navigation::currentPage() const
{
    return currentItem() ? currentItem()->data(kKeyRole).toString() : QString();
}

QListWidgetItem *Navigation::itemOf(const QString &key) const
{
    for (int row = 0; row < count(); ++row) {
        if (item(row)->data(kKeyRole).toString() == key && !key.isEmpty())
            return item(row);
    }
    return nullptr;
}

void Navigation::setCurrentPage(const QString &key)
{
    if (QListWidgetItem *found = itemOf(key))
        setCurrentItem(found);
}

bool Navigation::awaitPage(const QString &key)
{
    if (!itemOf(key))
        return false;
    m_awaited = key;
    return true;
}

QString Navigation::takeAwaited()
{
    return std::exchange(m_awaited, QString());
}

void Navigation::setMarked(const QString &key, bool marked)
{
    QListWidgetItem *found = itemOf(key);
    if (!found || found->data(kMarkRole).toBool() == marked)
        return;
    found->setData(kMarkRole, marked);
    const QString title = found->data(kTitleRole).toString();
    found->setText(marked ? title + kMark : title);
    found->setData(Qt::AccessibleTextRole, marked ? tr("%1, with unwritten changes").arg(title) : title);
}

void Navigation::setOffered(const QString &key, bool offered)
{
    if (QListWidgetItem *found = itemOf(key); found && found->isHidden() == offered) {
        found->setHidden(!offered);
        // Typing letters chooses hidden entries too, unless they cannot be chosen at all.
        found->setFlags(offered ? Qt::ItemIsSelectable | Qt::ItemIsEnabled : Qt::NoItemFlags);
        renumber();
        if (offered && key == m_awaited)
            setCurrentItem(found);
    }
}

// A heading is there for the entries beneath it.
void Navigation::renumber()
{
    int number = 0;
    QListWidgetItem *heading = nullptr;
    for (int row = 0; row < count(); ++row) {
        const QString title = item(row)->data(kTitleRole).toString();
        if (title.isEmpty()) {
            heading = item(row);
            heading->setHidden(true);
        } else if (!item(row)->isHidden()) {
            heading->setHidden(false);
            item(row)->setToolTip(++number <= kLastNumber ? tr("%1 (Ctrl+%2)").arg(title).arg(number)
                                                          : title);
        }
    }
}

QString Navigation::pageOfNumber(int number) const
{
    for (int row = 0; row < count(); ++row) {
        const QString key = item(row)->data(kKeyRole).toString();
        if (!key.isEmpty() && !item(row)->isHidden() && --number == 0)
            return key;
    }
    return {};
}

bool Navigation::isOffered(const QString &key) const
{
    const QListWidgetItem *found = itemOf(key);
    return found && !found->isHidden();
}

QString Navigation::titleOf(const QString &key) const
{
    const QListWidgetItem *found = itemOf(key);
    return found ? found->data(kTitleRole).toString() : QString();
}

QStringList Navigation::offeredTitles() const
{
    QStringList titles;
    for (int row = 0; row < count(); ++row) {
        if (const QString title = item(row)->data(kTitleRole).toString();
            !title.isEmpty() && !item(row)->isHidden())
            titles.append(title);
    }
    return titles;
}

QString Navigation::offeredInPlaceOf(const QString &key) const
{
    for (int row = 0; row < count(); ++row) {
        const QString other = item(row)->data(kKeyRole).toString();
        if (!other.isEmpty() && !item(row)->isHidden() && titleOf(other) == titleOf(key))
            return other;
    }
    return {};
}
