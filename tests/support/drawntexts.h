// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGraphicsView>
#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainter>
#include <QWidget>

/// Paper that keeps only the words drawn on it.
class WordPaper final : public QPaintDevice
{
public:
    explicit WordPaper(QSize size)
        : m_size(size)
    {
    }
    [[nodiscard]] QPaintEngine *paintEngine() const override { return &m_engine; }
    [[nodiscard]] QStringList words() const { return m_engine.words; }

protected:
    [[nodiscard]] int metric(PaintDeviceMetric metric) const override
    {
        switch (metric) {
        case PdmWidth: return m_size.width();
        case PdmHeight: return m_size.height();
        case PdmWidthMM:
        case PdmHeightMM: return 300;
        case PdmNumColors: return 1 << 24;
        case PdmDepth: return 24;
        case PdmDpiX:
        case PdmDpiY:
        case PdmPhysicalDpiX:
        case PdmPhysicalDpiY: return 96;
        case PdmDevicePixelRatio: return 1;
        case PdmDevicePixelRatioScaled: return int(devicePixelRatioFScale());
        }
        return 0;
    }

private:
    class Engine final : public QPaintEngine
    {
    public:
        Engine()
            : QPaintEngine(AllFeatures)
        {
        }
        bool begin(QPaintDevice *) override { return true; }
        bool end() override { return true; }
        void updateState(const QPaintEngineState &) override { }
        void drawPixmap(const QRectF &, const QPixmap &, const QRectF &) override { }
        void drawPath(const QPainterPath &) override { }
        void drawPolygon(const QPointF *, int, PolygonDrawMode) override { }
        void drawTextItem(const QPointF &, const QTextItem &item) override { words.append(item.text()); }
        [[nodiscard]] Type type() const override { return User; }

        QStringList words;
    };

    QSize m_size;
    mutable Engine m_engine;
};

/// Every text that a widget and all in it draw, and those of its charts even where a picture of them is kept.
inline QStringList drawnTexts(QWidget &widget)
{
    WordPaper paper(widget.size());
    widget.render(&paper);
    QStringList words = paper.words();
    for (QGraphicsView *view : widget.findChildren<QGraphicsView *>()) {
        if (!view->isVisible() || !view->scene())
            continue;
        WordPaper chart(view->size());
        QPainter painter(&chart);
        view->scene()->render(&painter);
        painter.end();
        words += chart.words();
    }
    return words;
}
