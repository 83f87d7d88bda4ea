// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/theme/theme.h"

#include <QApplication>
#include <QGuiApplication>
#include <QStyle>
#include <QStyleFactory>
#include <QWidget>

#include <algorithm>
#include <array>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

using Colors = std::array<QRgb, static_cast<std::size_t>(ColorRole::Count)>;

constexpr Colors kLight{0xFFF3F4F6, 0xFFFFFFFF, 0xFFE9EBEF, 0xFFC9CED6, 0xFF1B2027, 0xFF5A6472,
                        0xFF0B62A8, 0xFFFFFFFF, 0xFF17713D, 0xFF8A4B00, 0xFF8F5400, 0xFFB3201B,
                        0xFFFFFFFF, 0xFFB84F00, 0xFF00785A, 0xFF0072B2, 0xFFBFD9EE, 0xFFD9C9B2};
constexpr Colors kDark{0xFF16191E, 0xFF1F242B, 0xFF2A3038, 0xFF3D4550, 0xFFE7EAEE, 0xFFA3ADBA,
                       0xFF6CB4EE, 0xFF0D1116, 0xFF5CC98A, 0xFFF0B45C, 0xFFF0B45C, 0xFFFF7A70,
                       0xFF1B0604, 0xFFFF8F4D, 0xFF3DC79B, 0xFF5CB3EC, 0xFF28455E, 0xFF4A3F30};
constexpr std::array<QRgb, 8> kSeriesLight{0xFFA5477E, 0xFF6B7200, 0xFF3F5FBF, 0xFF8A5A00,
                                           0xFF00767A, 0xFF7A3FB0, 0xFF5A6472, 0xFFA82A2A};
constexpr std::array<QRgb, 8> kSeriesDark{0xFFE08FBE, 0xFFCFD34A, 0xFF95AEFF, 0xFFE9B44C,
                                          0xFF54CBD0, 0xFFC49BF0, 0xFFB6C0CC, 0xFFFF9C94};

// Placeholders @Role; sizes on the 4 px grid.
// clang-format off
constexpr QStringView kStyleSheet = uR"(
QToolTip { color: @Text; background: @Surface; border: 1px solid @Border; padding: 4px; }
QFrame#bar { background: @Surface; border: none; border-bottom: 1px solid @Border; }
QFrame#linkBar { background: @Surface; border: none; border-bottom: 3px solid @Border; }
QFrame#linkBar[marked="true"] { border-bottom-color: @Changed; }
QFrame#footBar { background: @Background; border: none; border-top: 1px solid @Border; }
QLabel#badge { background: @Changed; color: @Surface; border-radius: 4px; padding: 3px 8px; font-weight: 700; }
QLabel#badge[kind="readonly"] { background: @SurfaceRaised; color: @Text; border: 1px solid @Muted; padding: 2px 7px; }
QLabel#badge[kind="recording"] { background: @Danger; color: @DangerText; }
QFrame#statusBar { background: @Surface; border: none; border-top: 1px solid @Border; }
QFrame#unsavedBar { background: @SurfaceRaised; border: none; border-top: 2px solid @Changed; }
QFrame#panel { background: @Background; border: 1px solid @Border; border-radius: 6px; }
QFrame#card { background: @Surface; border: 1px solid @Border; border-radius: 6px; }
QFrame#fault { background: @Background; border: 1px solid @Warning; border-left: 6px solid @Warning; border-radius: 4px; }
QFrame#fault[severe="true"] { border-color: @Danger; }
QFrame#messageBar { background: @Surface; border: 1px solid @Ok; border-left: 4px solid @Ok; border-radius: 4px; }
QFrame#messageBar[warns="true"] { border-color: @Warning; }
QFrame#messageBar[severe="true"] { border-color: @Danger; }
QFrame#alarmBar { background: @Warning; border: none; border-radius: 0; }
QFrame#alarmBar[severe="true"] { background: @Danger; }
QFrame#alarmBar QLabel { color: @DangerText; background: transparent; }
QFrame#alarmBar QPushButton { background: @DangerText; color: @Danger; border: 2px solid @DangerText; }
QFrame#alarmBar[severe="false"] QPushButton { color: @Warning; }
QFrame#alarmBar QPushButton#alarmRemedy { font-weight: 700; }
QFrame#alarmBar QPushButton:focus { border: 2px solid @Text; }
QFrame#alarmCard { background: @SurfaceRaised; border: 1px solid @Danger; border-left: 4px solid @Danger; border-radius: 4px; }
QFrame#alarmCard[over="true"] { border-color: @Border; }
QFrame#offerBar { background: @Surface; border: 1px solid @Accent; border-left: 4px solid @Accent; border-radius: 4px; }
QListView#navigation { background: @Surface; border: none; border-radius: 0; border-right: 1px solid @Border; outline: none; padding: 8px 0; }
QListView#navigation::item { padding: 5px 12px; color: @Text; border: none; border-left: 4px solid @Surface; }
QListView#navigation::item:selected { background: @SurfaceRaised; color: @Accent; border-left: 4px solid @Accent; }
QListView#navigation::item:disabled { color: @Muted; padding: 8px 12px 2px 12px; }
QListView#navigation:focus { border: none; border-right: 2px solid @Accent; }
QListView, QTreeView, QTableView { background: @Surface; border: 1px solid @Border; border-radius: 4px; outline: none; }
QListView::item { padding: 4px 8px; border: none; }
QTreeView::item { min-height: 22px; }
QTableView::item { padding: 0 6px; border: none; }
QListView::item:selected, QTableView::item:selected, QTreeView::item:selected, QTreeView::branch:selected { background: @Accent; color: @AccentText; }
QHeaderView::section { background: @Background; color: @Muted; border: none; border-bottom: 1px solid @Border; padding: 4px 8px; }
QScrollArea { border: none; background: transparent; }
QScrollArea > QWidget > QWidget { background: transparent; }
QPushButton, QToolButton { background: @SurfaceRaised; border: 1px solid @Border; border-radius: 4px; padding: 4px 12px; min-height: 20px; }
QPushButton:hover, QToolButton:hover { border-color: @Accent; }
QPushButton:focus, QToolButton:focus { border: 2px solid @Accent; padding: 3px 11px; }
QPushButton:disabled, QToolButton:disabled { color: @Muted; }
QPushButton:checked, QToolButton:checked { background: @Accent; color: @AccentText; }
QPushButton#primary { background: @Accent; color: @AccentText; border-color: @Accent; }
QPushButton#primary:disabled { background: @SurfaceRaised; color: @Muted; border-color: @Border; }
QPushButton#primary:focus, QPushButton:checked:focus, QToolButton:checked:focus { border: 2px solid @Text; }
QPushButton#danger { background: @Danger; color: @DangerText; border-color: @Danger; font-weight: 600; }
QPushButton#danger:focus { border: 2px solid @Text; }
QPushButton#danger:disabled { background: @SurfaceRaised; color: @Muted; border-color: @Border; }
QPushButton#motors { font-weight: 700; padding: 6px 16px; border: 2px solid @Ok; color: @Ok; background: @Surface; }
QPushButton#motors[running="true"] { background: @Danger; border-color: @Danger; color: @DangerText; }
QPushButton#motors:disabled { border-color: @Border; color: @Muted; background: @Surface; }
QPushButton#motors:focus { border: 3px solid @Text; padding: 5px 15px; }
QToolButton#plotMenu { border: 1px solid transparent; background: transparent; padding: 2px 6px; min-height: 0; font-weight: 700; }
QToolButton#plotMenu:hover, QToolButton#plotMenu:focus { border: 1px solid @Accent; padding: 2px 6px; }
QToolButton#plotMenu::menu-indicator { image: none; }
QToolButton#reset { border: none; background: transparent; color: @Changed; padding: 0; min-height: 0; }
QToolButton#reset:hover { text-decoration: underline; }
QToolButton#reset:focus { border: 1px solid @Accent; }
QLineEdit > QToolButton, QLineEdit > QToolButton:focus { border: none; background: transparent; padding: 0; min-height: 0; }
QPushButton::menu-indicator { image: url(:/icons/down.svg); width: 10px; subcontrol-position: right center; right: 8px; }
QPushButton[field="true"] { background: @Surface; padding: 2px 6px; min-height: 22px; text-align: left; }
QPushButton[field="true"]:focus { border: 2px solid @Accent; padding: 1px 5px; }
QPushButton#chip { border-radius: 12px; padding: 2px 12px; background: transparent; }
QPushButton#chip:checked { background: @Accent; color: @AccentText; }
QPushButton#chip:checked:focus { border: 2px solid @Text; padding: 1px 11px; }
QLineEdit, QComboBox, QAbstractSpinBox { background: @Surface; border: 1px solid @Border; border-radius: 4px; padding: 2px 6px; min-height: 22px; }
QAbstractSpinBox::up-button, QAbstractSpinBox::down-button { width: 0; border: none; }
QScrollBar:vertical { background: transparent; width: 12px; margin: 0; }
QScrollBar:horizontal { background: transparent; height: 12px; margin: 0; }
QScrollBar::handle { background: @Border; border-radius: 4px; margin: 2px; }
QScrollBar::handle:vertical { min-height: 28px; }
QScrollBar::handle:horizontal { min-width: 28px; }
QScrollBar::handle:hover { background: @Muted; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
QAbstractScrollArea::corner { background: transparent; border: none; }
QComboBox { combobox-popup: 0; }
QComboBox QAbstractItemView, QComboBox QAbstractItemView:focus { border: 1px solid @Accent; background: @Surface; }
QComboBox QAbstractItemView::item { min-height: 24px; padding: 0 6px; }
QComboBox QAbstractItemView::item:selected { background: @Accent; color: @AccentText; }
QComboBox::drop-down { border: none; width: 22px; }
QComboBox::down-arrow { image: url(:/icons/down.svg); width: 10px; height: 10px; }
QLineEdit:focus, QComboBox:focus, QAbstractSpinBox:focus { border: 2px solid @Accent; padding: 1px 5px; }
QLineEdit:disabled, QComboBox:disabled, QAbstractSpinBox:disabled { color: @Muted; background: @Background; }
QAbstractSpinBox[inactive="true"], QComboBox[inactive="true"], QPushButton[inactive="true"] { color: @Muted; background: @Background; }
QAbstractSpinBox[changed="true"], QComboBox[changed="true"], QPushButton[changed="true"] { border-left: 4px solid @Changed; }
QAbstractSpinBox[changed="true"]:focus, QComboBox[changed="true"]:focus { border: 2px solid @Accent; border-left: 4px solid @Changed; }
QAbstractSpinBox[refused="true"], QAbstractSpinBox[refused="true"]:focus, QLineEdit[refused="true"], QLineEdit[refused="true"]:focus { border: 2px solid @Danger; padding: 1px 5px; color: @Danger; }
QComboBox[conflict="true"], QComboBox[conflict="true"]:focus, QAbstractSpinBox[conflict="true"], QAbstractSpinBox[conflict="true"]:focus, QPushButton[conflict="true"] { border: 2px solid @Danger; padding: 1px 5px; color: @Danger; }
QToolButton#hint { background: @Danger; color: @DangerText; border: none; border-radius: 4px; padding: 2px 8px; min-height: 0; }
QCheckBox, QRadioButton { border: 2px solid transparent; border-radius: 4px; }
QCheckBox[changed="true"] { border-left: 4px solid @Changed; padding-left: 4px; }
QCheckBox:focus, QRadioButton:focus { border-color: @Text; }
QLabel#title { font-weight: 600; }
QLabel#section { font-weight: 600; color: @Text; }
QLabel#muted, QLabel#unit { color: @Muted; }
QLabel#changed { color: @Changed; }
QLabel#error { color: @Danger; }
QLabel#warning { color: @Warning; }
QLabel#ok { color: @Ok; }
QCheckBox::indicator, QTreeView::indicator, QTableView::indicator { width: 14px; height: 14px; border: 1px solid @Muted; border-radius: 3px; background: @Surface; }
QRadioButton::indicator { width: 14px; height: 14px; border: 1px solid @Muted; border-radius: 8px; background: @Surface; }
QRadioButton::indicator:checked { width: 6px; height: 6px; border: 5px solid @Accent; border-radius: 8px; background: @Surface; }
QCheckBox::indicator:checked, QTreeView::indicator:checked, QTableView::indicator:checked { background: @Accent; border-color: @Accent; image: url(:/icons/@CheckIcon.svg); }
QTreeView::indicator:checked:selected, QTableView::indicator:checked:selected { border-color: @AccentText; }
QSlider::groove:horizontal { height: 4px; border-radius: 2px; background: @Border; }
QSlider::sub-page:horizontal { height: 4px; border-radius: 2px; background: @Accent; }
QSlider::sub-page:horizontal:disabled { background: @Border; }
QSlider::handle:horizontal { width: 14px; height: 14px; margin: -6px 0; border-radius: 7px; background: @Accent; border: 1px solid @Surface; }
QSlider::handle:horizontal:focus { border: 3px solid @Text; margin: -7px -1px; }
QSlider::handle:horizontal:disabled { background: @Muted; }
QSlider::groove:vertical { width: 4px; border-radius: 2px; background: @Border; }
QSlider::add-page:vertical { width: 4px; border-radius: 2px; background: @Accent; }
QSlider::add-page:vertical:disabled { background: @Border; }
QSlider::handle:vertical { width: 14px; height: 14px; margin: 0 -6px; border-radius: 7px; background: @Accent; border: 1px solid @Surface; }
QSlider::handle:vertical:focus { border: 3px solid @Text; margin: -1px -7px; }
QSlider::handle:vertical:disabled { background: @Muted; }
QTextBrowser { background: @Surface; border: 1px solid @Border; border-radius: 4px; }
QTextBrowser:focus, QListView:focus, QTreeView:focus, QTableView:focus { border: 2px solid @Accent; }
QSplitter::handle { background: @Background; }
QProgressBar { border: 1px solid @Border; border-radius: 4px; background: @Background; text-align: center; min-height: 18px; }
QProgressBar::chunk { background: @Accent; }
)";
// clang-format on

double luminance(const QColor &color)
{
    const auto channel = [](double value) {
        return value <= 0.03928 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * channel(color.redF()) + 0.7152 * channel(color.greenF())
        + 0.0722 * channel(color.blueF());
}

}  // namespace

Theme::Theme(QObject *parent)
    : QObject(parent)
{
    setMode(Mode::System);
}

void Theme::setMode(Mode mode)
{
    const bool dark = mode == Mode::System ? QGuiApplication::palette().window().color().lightness() < 128
                                           : mode == Mode::Dark;
    m_dark = dark;
    emit changed();
}

QColor Theme::color(ColorRole role) const
{
    return QColor::fromRgb((m_dark ? kDark : kLight)[static_cast<std::size_t>(role)]);
}

QColor Theme::axisColor(Axis axis) const
{
    switch (axis) {
    case Axis::Roll: return color(ColorRole::AxisRoll);
    case Axis::Pitch: return color(ColorRole::AxisPitch);
    case Axis::Yaw: return color(ColorRole::AxisYaw);
    case Axis::None: break;
    }
    return color(ColorRole::Text);
}

QColor Theme::seriesColor(int index) const
{
    const auto &colors = m_dark ? kSeriesDark : kSeriesLight;
    return QColor::fromRgb(colors[static_cast<std::size_t>(index) % colors.size()]);
}

double Theme::contrast(const QColor &a, const QColor &b)
{
    const double la = luminance(a);
    const double lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

QPalette Theme::palette() const
{
    QPalette palette;
    const auto set = [&](QPalette::ColorRole role, ColorRole from) { palette.setColor(role, color(from)); };
    set(QPalette::Window, ColorRole::Background);
    set(QPalette::WindowText, ColorRole::Text);
    set(QPalette::Base, ColorRole::Surface);
    set(QPalette::AlternateBase, ColorRole::Background);
    set(QPalette::Text, ColorRole::Text);
    set(QPalette::Button, ColorRole::SurfaceRaised);
    set(QPalette::ButtonText, ColorRole::Text);
    set(QPalette::BrightText, ColorRole::Danger);
    set(QPalette::Highlight, ColorRole::Accent);
    set(QPalette::HighlightedText, ColorRole::AccentText);
    set(QPalette::ToolTipBase, ColorRole::Surface);
    set(QPalette::ToolTipText, ColorRole::Text);
    set(QPalette::PlaceholderText, ColorRole::Muted);
    set(QPalette::Link, ColorRole::Accent);
    set(QPalette::Mid, ColorRole::Border);
    set(QPalette::Midlight, ColorRole::SurfaceRaised);
    set(QPalette::Dark, ColorRole::Border);
    for (const auto role : {QPalette::Text, QPalette::WindowText, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, color(ColorRole::Muted));
    return palette;
}

QString Theme::styleSheet() const
{
    QString sheet = kStyleSheet.toString();
    constexpr std::array<std::pair<const char *, ColorRole>, 16> names{
        {{"@SurfaceRaised", ColorRole::SurfaceRaised},
         {"@Surface", ColorRole::Surface},
         {"@Background", ColorRole::Background},
         {"@Border", ColorRole::Border},
         {"@Text", ColorRole::Text},
         {"@Muted", ColorRole::Muted},
         {"@AccentText", ColorRole::AccentText},
         {"@Accent", ColorRole::Accent},
         {"@Ok", ColorRole::Ok},
         {"@Changed", ColorRole::Changed},
         {"@Warning", ColorRole::Warning},
         {"@DangerText", ColorRole::DangerText},
         {"@Danger", ColorRole::Danger},
         {"@AxisRoll", ColorRole::AxisRoll},
         {"@AxisPitch", ColorRole::AxisPitch},
         {"@AxisYaw", ColorRole::AxisYaw}}};
    sheet.replace(u"@CheckIcon"_s, m_dark ? u"check-dark"_s : u"check-light"_s);
    for (const auto &[name, role] : names)
        sheet.replace(QLatin1String(name), color(role).name());
    return sheet;
}

void repolish(QWidget *widget)
{
    widget->style()->unpolish(widget);
    widget->style()->polish(widget);
    widget->update();
}

void Theme::apply()
{
    QApplication::setStyle(QStyleFactory::create(u"Fusion"_s));
    QApplication::setPalette(palette());
    qApp->setStyleSheet(styleSheet());
}
