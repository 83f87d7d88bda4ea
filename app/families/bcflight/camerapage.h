// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"
#include "protocol/video/videopipeline.h"

class ElidedLabel;
class FullView;
class PictureSettings;
class QLineEdit;
class QPushButton;
class TransmitterCard;
class VideoView;

/// The live picture of a drone's camera, pictures and recordings of it in files, and what the camera and an
/// analog transmitter can be told. Video is received while the page is seen, or recorded.
class CameraPage final : public Page
{
    Q_OBJECT
public:
    explicit CameraPage(Workspace &workspace, QWidget *parent = nullptr);
    ~CameraPage() override;

    [[nodiscard]] bool isUnderWay() const override { return m_video.isRecording(); }
    [[nodiscard]] VideoView *view() const { return m_view; }
    [[nodiscard]] VideoPipeline &video() { return m_video; }
    [[nodiscard]] PictureSettings *settings() const { return m_settings; }
    [[nodiscard]] TransmitterCard *transmitter() const { return m_transmitter; }
    [[nodiscard]] QPushButton *recordButton() const { return m_record; }
    [[nodiscard]] QPushButton *stillButton() const { return m_still; }
    [[nodiscard]] QPushButton *fullButton() const { return m_full; }
    [[nodiscard]] QLineEdit *addressField() const { return m_address; }
    [[nodiscard]] QLineEdit *folderField() const { return m_folder; }
    /// What is wrong with the picture that is shown; empty while it is live.
    [[nodiscard]] QString staleText() const { return m_cover->text(); }
    [[nodiscard]] QString figures() const;
    [[nodiscard]] FullView *fullView() const { return m_fullView.get(); }

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    void makeLeft();
    void makeRight();
    void connectAll();
    [[nodiscard]] QWidget *makeConnection();

    /// Where the video comes from. Errors: InvalidArgument, NotConnected, Unsupported.
    [[nodiscard]] Result<VideoAddress> wantedAddress() const;
    /// Receives from there while it is of use.
    void follow();
    void restart();
    void takeAddress();
    void refresh();
    void showRecording();
    [[nodiscard]] QString waitingText(const VideoStatistics &statistics) const;
    [[nodiscard]] QString figuresText(const VideoStatistics &statistics) const;
    [[nodiscard]] QString folder() const;
    void takeFolder();
    void onStill(const std::shared_ptr<const VideoPicture> &picture);
    void toggleRecording();
    void onRecordingEnded(const VideoRecordingState &state);

    VideoPipeline m_video;
    std::optional<Error> m_trouble;  // why nothing is received
    std::optional<VideoAddress> m_shown;  // of the picture
    TimePoint m_startedAt{};
    VideoView *m_view;
    StaleCover *m_cover;
    std::unique_ptr<FullView> m_fullView;
    PictureSettings *m_settings;
    TransmitterCard *m_transmitter;
    QPushButton *m_record;
    QPushButton *m_still;
    QPushButton *m_full;
    QLineEdit *m_folder;
    QLineEdit *m_address;
    ElidedLabel *m_figures;
    ElidedLabel *m_recording;
};
