// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/forms/parameterform.h"

#include "widgets/forms/filterrows.h"
#include "widgets/forms/valueeditor.h"
#include "widgets/models/parametermodel.h"
#include "widgets/theme/theme.h"

#include <QGridLayout>
#include <QLabel>
#include <QResizeEvent>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;

namespace {

constexpr int kLabelWidth = 148;  // of all labels, so that all fields begin at the same place

QLabel *makeLabel(const QString &text, const char *objectName)
{
    auto *label = new QLabel(text);
    label->setObjectName(QLatin1String(objectName));
    return label;
}

}  // namespace

ParameterForm::ParameterForm(ConfigurationModel &configuration, EditStack &edits, QWidget *parent)
    : QWidget(parent)
    , m_configuration(configuration)
    , m_edits(edits)
{
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    connect(&m_configuration, &ConfigurationModel::valueChanged, this, [this](int parameter) {
        refresh(parameter);
        if (m_filterRows && m_filterRows->concerns(parameter))
            refreshAll();
        const QString key = m_configuration.edited().parameters().at(parameter).key;
        const auto &rules = m_set->rules();
        const auto areBound = [&](const QString &other) {
            return std::any_of(rules.begin(), rules.end(), [&](const ValueRule &rule) {
                return rule.concerns(key) && rule.concerns(other);
            });
        };
        for (auto it = m_editors.begin(); it != m_editors.end(); ++it) {
            const ParameterSpec &spec = m_set->at(it.key());
            if (spec.inactiveKey() == key || areBound(spec.key))
                refresh(it.key());
        }
    });
    connect(&m_configuration, &ConfigurationModel::shownProfileChanged, this, [this] {
        for (ValueEditor *editor : std::as_const(m_editors))
            editor->forgetTyping();
        refreshAll();
    });
    connect(&m_configuration, &ConfigurationModel::changeCountChanged, this, &ParameterForm::refreshAll);
    connect(&m_edits.refused(), &RefusedTexts::replaced, this, [this] {
        if (m_set == m_configuration.edited().parameterSet())  // else it is built anew in a moment
            refreshAll();
    });
}

void ParameterForm::setParameters(const QList<int> &parameters)
{
    m_parameters = parameters;
    rebuild();
}

int ParameterForm::columnsFor(int width) const
{
    return std::clamp(width / (Metric::kFieldWidth - 60), 1, 3);
}

void ParameterForm::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    // Wide windows get more columns, not longer fields.
    if (columnsFor(event->size().width()) != m_columns)
        rebuild();
}

void ParameterForm::rebuild()
{
    m_columns = columnsFor(width());
    // Rearranging must not take away the field that the operator is using, nor what stands half typed in it.
    QString focused;
    std::optional<QString> unfinished;
    for (const ValueEditor *editor : std::as_const(m_editors)) {
        if (editor->control()->hasFocus()) {
            focused = editor->spec().key;
            unfinished = editor->unfinishedText();
        }
    }
    const QString serial = std::exchange(m_serial, m_configuration.board().identity().serial);
    m_editors.clear();
    m_filterRows = nullptr;
    delete m_body;
    m_body = new QWidget(this);
    layout()->addWidget(m_body);
    auto *body = new QVBoxLayout(m_body);
    body->setContentsMargins(0, 0, 0, 0);
    body->setSpacing(Metric::kGap);
    m_set = m_configuration.edited().parameterSet();
    if (m_configuration.isEmpty())
        return;
    // Parameters come group by group; each group is a block with a heading.
    for (qsizetype first = 0; first < m_parameters.size();) {
        const char *group = m_set->at(m_parameters[first]).row->group;
        qsizetype last = first;
        QList<int> members;
        for (; last < m_parameters.size(); ++last) {
            if (qstrcmp(m_set->at(m_parameters[last]).row->group, group) != 0)
                break;
            members.append(m_parameters[last]);
        }
        addGroup(body, group, members);
        first = last;
    }
    body->addStretch(1);
    refreshAll();
    const ParameterSpec *spec = m_set->find(focused);
    ValueEditor *editor = spec ? m_editors.value(spec->id) : nullptr;
    if (!editor)
        return;
    editor->control()->setFocus();
    if (unfinished && serial == m_serial)
        editor->goOnTyping(*unfinished);
}

void ParameterForm::addGroup(QVBoxLayout *layout, const char *group, const QList<int> &parameters)
{
    auto *heading = makeLabel(tableText(group), "section");
    if (layout->count() > 0)
        layout->addSpacing(Metric::kGroupGap - Metric::kGap);
    layout->addWidget(heading);

    // Rows that exist for several axes become a matrix; values of one row stand next to each other in the
    // list.
    QList<QList<int>> matrix;
    QList<int> single;
    const ParameterSet &set = *m_set;
    for (const int id : withoutFilters(parameters, layout)) {
        const ParameterSpec &spec = set.at(id);
        if (spec.row->axes < 2) {
            single.append(id);
            continue;
        }
        const bool continues = !matrix.isEmpty() && set.at(matrix.last().first()).row == spec.row
            && set.at(matrix.last().first()).index == spec.index;
        if (continues)
            matrix.last().append(id);
        else
            matrix.append(QList<int>{id});
    }
    if (!matrix.isEmpty())
        layout->addWidget(makeMatrix(matrix));
    if (!single.isEmpty())
        layout->addWidget(makeFields(single));
}

QList<int> ParameterForm::withoutFilters(const QList<int> &parameters, QVBoxLayout *layout)
{
    std::vector<NotchFilter> shown;
    QList<int> rest = parameters;
    for (const NotchFilter &filter : m_filters) {
        QList<int> own;
        for (const QString &key : {filter.frequency, filter.width, filter.depth}) {
            const ParameterSpec *spec = m_set->find(key);
            if (spec && parameters.contains(spec->id))
                own.append(spec->id);
        }
        if (own.size() < 3 || !m_set->find(filter.enabled))
            continue;
        shown.push_back(filter);
        for (const int id : own)
            rest.removeOne(id);
    }
    if (!shown.empty()) {
        m_filterRows = new FilterRows(m_configuration, m_edits, shown,
                                      [this](int parameter) { return makeEditor(parameter); });
        layout->addWidget(m_filterRows);
    }
    return rest;
}

QWidget *ParameterForm::makeMatrix(const QList<QList<int>> &rows)
{
    const ParameterSet &set = *m_set;
    auto *widget = new QWidget;
    auto *grid = new QGridLayout(widget);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(Metric::kGap);
    grid->setVerticalSpacing(Metric::kGap);
    for (int axis = 0; axis < kAxisCount; ++axis) {
        auto *head = makeLabel(axisLabel(kAxes[std::size_t(axis)]), "muted");
        head->setAlignment(Qt::AlignCenter);
        grid->addWidget(head, 0, axis + 1);
        grid->setColumnMinimumWidth(axis + 1, 112);
        grid->setColumnStretch(axis + 1, 2);
    }
    int line = 1;
    for (const QList<int> &row : rows) {
        const ParameterSpec &first = set.at(row.first());
        auto *name
            = makeLabel(parameterLabel(first, false), first.row->risk == Risk::Red ? "warning" : "label");
        if (first.row->risk == Risk::Red)
            name->setText(u"⚠ "_s + name->text());
        name->setToolTip(tableText(first.row->help));
        name->setWordWrap(true);
        name->setFixedWidth(kLabelWidth);
        grid->addWidget(name, line, 0, Qt::AlignLeft | Qt::AlignVCenter);
        for (const int id : row)
            grid->addWidget(makeEditor(id), line, int(set.at(id).axis) + 1, Qt::AlignTop);
        if (*first.row->unit) {
            grid->addWidget(makeLabel(QString::fromUtf8(first.row->unit), "unit"), line, 4, Qt::AlignVCenter);
            grid->setColumnStretch(4, 1);
        }
        ++line;
    }
    widget->setMaximumWidth(2 * Metric::kFieldWidth);
    return widget;
}

QWidget *ParameterForm::makeFields(const QList<int> &parameters)
{
    const ParameterSet &set = *m_set;
    auto *widget = new QWidget;
    auto *grid = new QGridLayout(widget);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(Metric::kMargin);
    grid->setVerticalSpacing(Metric::kGap);
    for (int i = 0; i < parameters.size(); ++i) {
        const ParameterSpec &spec = set.at(parameters[i]);
        auto *cell = new QWidget;
        cell->setMinimumWidth(Metric::kFieldWidth - 80);
        cell->setMaximumWidth(Metric::kFieldWidth);
        auto *row = new QGridLayout(cell);
        row->setContentsMargins(0, 0, 0, 0);
        row->setHorizontalSpacing(Metric::kGap);
        QString text = parameterLabel(spec);
        if (spec.row->risk == Risk::Red)
            text.prepend(u"⚠ "_s);
        auto *name = makeLabel(text, spec.row->risk == Risk::Red ? "warning" : "label");
        name->setWordWrap(true);
        name->setFixedWidth(kLabelWidth);
        name->setToolTip(tableText(spec.row->help));
        ValueEditor *editor = makeEditor(parameters[i]);
        name->setBuddy(editor->control());
        row->addWidget(name, 0, 0);
        row->addWidget(editor, 0, 1, Qt::AlignTop);
        row->addWidget(makeLabel(QString::fromUtf8(spec.row->unit), "unit"), 0, 2);
        row->setColumnStretch(1, 1);
        row->setColumnMinimumWidth(2, 28);
        grid->addWidget(cell, i / m_columns, i % m_columns, Qt::AlignTop | Qt::AlignLeft);
    }
    grid->setColumnStretch(m_columns, 1);
    return widget;
}

ValueEditor *ParameterForm::makeEditor(int parameter)
{
    const ParameterSet &set = *m_set;
    auto *editor = new ValueEditor(set.at(parameter), set.firmware());
    editor->setEnabled(m_configuration.board().identity().writable);
    m_editors.insert(parameter, editor);
    connect(editor, &ValueEditor::edited, this, [this, parameter](double raw) {
        if (!m_edits.edit(parameter, m_configuration.shownProfile(), raw))
            refresh(parameter);
    });
    connect(editor, &ValueEditor::refusedChanged, this, [this, editor] {
        m_edits.refused().set(editor->spec(), m_configuration.shownProfile(), editor->refusedText());
    });
    connect(editor, &ValueEditor::focused, this, [this, parameter] { emit parameterFocused(parameter); });
    return editor;
}

void ParameterForm::refresh(int parameter)
{
    ValueEditor *shown = m_editors.value(parameter);
    if (!shown)
        return;
    const ParameterSpec &spec = m_set->at(parameter);
    const int profile = m_configuration.shownProfile();
    QString reason = inactiveReason(m_configuration, spec, profile);
    if (reason.isEmpty() && m_filterRows)
        reason = m_filterRows->inactiveReason(parameter);
    shown->setInactive(reason);
    shown->setContradiction(contradictionText(m_configuration, spec, profile));
    shown->show(m_configuration.value(spec, profile), m_configuration.boardValue(spec, profile),
                !std::as_const(m_configuration).board().findMissing(spec, profile));
    shown->showFigure(std::as_const(m_configuration)
                          .board()
                          .textFigure(spec, m_configuration.value(spec, profile).value_or(std::nan(""))));
    shown->showRefused(m_edits.refused().text(spec, profile));
}

void ParameterForm::refreshAll()
{
    for (auto it = m_editors.begin(); it != m_editors.end(); ++it)
        refresh(it.key());
    if (m_filterRows)
        m_filterRows->refresh();
}
