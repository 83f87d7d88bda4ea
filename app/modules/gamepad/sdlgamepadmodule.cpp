// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/modules/gamepad/sdlgamepadmodule.h"

#include <SDL2/SDL.h>
#include <algorithm>
#include <array>
#include <map>

using namespace Qt::StringLiterals;

namespace {

constexpr double kFullWay = 32767.0;
// Joysticks, and what is known of their layouts.
constexpr Uint32 kSubsystem = SDL_INIT_GAMECONTROLLER;
constexpr std::array<int, 4> kHatDirections{SDL_HAT_UP, SDL_HAT_RIGHT, SDL_HAT_DOWN, SDL_HAT_LEFT};

QByteArray layoutOf(int index)
{
    char *text = SDL_GameControllerMappingForDeviceIndex(index);
    const QByteArray layout(text);
    SDL_free(text);
    return layout;
}

// Only the joysticks of SDL are started: no video, no signals, no window.
class SdlGamepads final : public GamepadSource
{
public:
    ~SdlGamepads() override
    {
        for (SDL_Joystick *pad : m_open)
            SDL_JoystickClose(pad);
        if (m_isOpen)
            SDL_QuitSubSystem(kSubsystem);
        SDL_TLSCleanup();  // this thread is none of SDL's own
    }

    Result<void> open() override
    {
        SDL_SetMainReady();
        SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
        SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS,
                    "1");  // whoever steers ends it when the window goes
        if (SDL_InitSubSystem(kSubsystem) != 0)
            return failure(ErrorCode::Unsupported, QString::fromUtf8(SDL_GetError()));
        SDL_GameControllerEventState(SDL_IGNORE);
        SDL_JoystickEventState(SDL_IGNORE);  // it is polled; nobody takes events out of their queue
        m_isOpen = true;
        return {};
    }

    std::vector<GamepadReading> poll() override
    {
        SDL_JoystickUpdate();
        followPlugs();
        std::vector<GamepadReading> pads;
        for (SDL_Joystick *pad : m_open)
            pads.push_back(reading(pad));
        return pads;
    }

private:
    void followPlugs()
    {
        std::erase_if(m_open, [this](SDL_Joystick *pad) {
            if (SDL_JoystickGetAttached(pad))
                return false;
            m_layouts.erase(SDL_JoystickInstanceID(pad));
            SDL_JoystickClose(pad);
            return true;
        });
        for (int at = 0; at < SDL_NumJoysticks(); ++at) {
            const SDL_JoystickID id = SDL_JoystickGetDeviceInstanceID(at);
            const bool isKnown = std::any_of(m_open.begin(), m_open.end(), [id](SDL_Joystick *pad) {
                return SDL_JoystickInstanceID(pad) == id;
            });
            if (!isKnown) {
                if (SDL_Joystick *pad = SDL_JoystickOpen(at)) {
                    m_open.push_back(pad);
                    m_layouts[id] = layoutOf(at);
                }
            }
        }
    }

    [[nodiscard]] GamepadReading reading(SDL_Joystick *pad) const
    {
        std::array<char, 33> guid{};
        SDL_JoystickGetGUIDString(SDL_JoystickGetGUID(pad), guid.data(), int(guid.size()));
        const SDL_JoystickID id = SDL_JoystickInstanceID(pad);
        GamepadReading now{id, guid.data(), QString::fromUtf8(SDL_JoystickName(pad)), {}, {}};
        if (const auto layout = m_layouts.find(id); layout != m_layouts.end())
            now.layout = layout->second;
        for (int axis = 0; axis < SDL_JoystickNumAxes(pad); ++axis)
            now.axes.push_back(std::max(-1.0, SDL_JoystickGetAxis(pad, axis) / kFullWay));
        for (int button = 0; button < SDL_JoystickNumButtons(pad); ++button)
            now.buttons.push_back(SDL_JoystickGetButton(pad, button) != 0);
        for (int hat = 0; hat < SDL_JoystickNumHats(pad); ++hat) {
            const int directions = SDL_JoystickGetHat(pad, hat);
            for (const int direction : kHatDirections)
                now.buttons.push_back((directions & direction) != 0);
        }
        return now;
    }

    std::vector<SDL_Joystick *> m_open;
    std::map<SDL_JoystickID, QByteArray> m_layouts;
    bool m_isOpen = false;
};

}  // namespace

std::unique_ptr<GamepadSource> SdlGamepadModule::makeSource() const
{
    return std::make_unique<SdlGamepads>();
}
