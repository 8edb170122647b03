"""The microphone on a WAV file: “yeah”, a long turn, and “uh-huh”.

`sounds/listener.wav` was spoken by espeak-ng, an artificial voice, with a little noise added. A
microphone cannot be had here: `PretendedSound` stands for PortAudio, and says so.
"""

from __future__ import annotations

import wave
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from adaptation.sensing.contract import check_sensor
from adaptation.sensing.cues import EndOfCues
from adaptation.sensing.microphone import Microphone, backchannel, silero
from adaptation.sensing.sound import CHUNK, Device, SoundSource, WavFile, sound_of
from personage_lite.errors import PersonageError

LISTENER = Path(__file__).parent / "sounds" / "listener.wav"
# When the three are spoken, in seconds.
YEAH, TURN, UH_HUH = (1.0, 1.44), (3.94, 8.31), (11.31, 11.87)


def heard(source: SoundSource) -> list[tuple[float, float | None]]:
    """Return time and back-channel of each tick."""
    now = [0.0]
    microphone = Microphone(source, lambda: now[0], silero)
    microphone.start()
    found = []
    try:
        for tick in range(1000):
            now[0] = tick * 0.2
            found.append((now[0], microphone.read().cues.get("backchannel")))
    except EndOfCues:
        microphone.stop()
        return found
    raise AssertionError("no end")


def sure(found: list[tuple[float, float | None]]) -> list[float]:
    return [round(time, 1) for time, value in found if value is not None and value > 0.5]


def test_short_sounds_of_listening_are_back_channels_and_turns_are_not() -> None:
    times = sure(heard(WavFile(str(LISTENER))))
    early = [time for time in times if time < TURN[0]]
    late = [time for time in times if time > UH_HUH[0]]
    assert early + late == times, "the long turn is no back-channel"
    assert YEAH[1] < early[0] < YEAH[1] + 0.6
    assert 1.4 < early[-1] - early[0] <= 2.0
    assert UH_HUH[1] < late[0] < UH_HUH[1] + 0.6


def test_the_same_file_is_heard_the_same_way() -> None:
    assert heard(WavFile(str(LISTENER))) == heard(WavFile(str(LISTENER)))


def write(path: Path, samples: Any, rate: int = 16_000, width: int = 2, channels: int = 1) -> Path:
    with wave.open(str(path), "wb") as file:
        file.setnchannels(channels)
        file.setsampwidth(width)
        file.setframerate(rate)
        file.writeframes(samples.tobytes())
    return path


def spoken() -> Any:
    return np.frombuffer(sound_of(str(LISTENER)), "<i2")


@pytest.mark.parametrize("kind", ["8 bit", "24 bit", "32 bit", "stereo", "44100", "8000"])
def test_any_pcm_file_will_do(tmp_path: Path, kind: str) -> None:
    sound, path = spoken(), tmp_path / "a.wav"
    if kind == "8 bit":
        write(path, (sound.astype(int) // 256 + 128).astype(np.uint8), width=1)
    elif kind == "24 bit":
        wide = (sound.astype("<i4") << 8).view(np.uint8).reshape(-1, 4)[:, :3]
        write(path, np.ascontiguousarray(wide), width=3)
    elif kind == "32 bit":
        write(path, sound.astype("<i4") << 16, width=4)
    elif kind == "stereo":
        write(path, np.column_stack([sound, sound]), channels=2)
    else:
        rate = int(kind)
        at = np.arange(int(len(sound) * rate / 16_000)) * 16_000 / rate
        write(path, np.interp(at, np.arange(len(sound)), sound).astype("<i2"), rate=rate)
    plain, other = sure(heard(WavFile(str(LISTENER)))), sure(heard(WavFile(str(path))))
    assert other[0] == pytest.approx(plain[0], abs=0.45)
    assert other[-1] == pytest.approx(plain[-1], abs=0.45)
    assert not [time for time in other if TURN[0] < time < UH_HUH[0]]


def test_noise_and_tones_are_no_voice(tmp_path: Path) -> None:
    random = np.random.default_rng(0)
    silence = np.zeros(16_000)
    noise = random.normal(0, 0.2, 8_000)
    tone = 0.4 * np.sin(2 * np.pi * 440 * np.arange(8_000) / 16_000)
    for sound in (noise, tone):
        samples = (np.concatenate([silence, sound, silence]).clip(-1, 1) * 32767).astype("<i2")
        assert sure(heard(WavFile(str(write(tmp_path / "a.wav", samples))))) == []


def test_the_length_decides() -> None:
    likely = [backchannel(seconds) for seconds in (0.03, 0.2, 0.5, 0.8)]
    assert likely[0] < 0.1
    assert min(likely[1:]) > 0.8
    lengths = [backchannel(seconds) for seconds in (0.9, 1.0, 1.1, 1.5, 4.0, 1e6)]
    assert lengths == sorted(lengths, reverse=True)
    assert lengths[-1] == pytest.approx(0.05)


def test_it_keeps_the_contract_of_sensors() -> None:
    faults = check_sensor(lambda clock: Microphone(WavFile(str(LISTENER)), clock, silero))
    assert [fault for fault in faults if "at once" not in fault] == []


@pytest.mark.parametrize(
    ("content", "line"),
    [
        (b"", "no WAV file .it ends too soon.; give one of PCM samples"),
        (b"hello, this is no sound at all", "no WAV file .file does not start with RIFF id."),
        (LISTENER.read_bytes()[:30], "no WAV file"),
    ],
)
def test_what_is_no_wav_file(tmp_path: Path, content: bytes, line: str) -> None:
    path = tmp_path / "a.wav"
    path.write_bytes(content)
    with pytest.raises(PersonageError, match=line):
        sound_of(str(path))
    with pytest.raises(PersonageError, match="cannot be read"):
        sound_of(str(tmp_path / "none.wav"))


def test_a_file_that_is_cut_off_is_heard_to_there(tmp_path: Path) -> None:
    path = tmp_path / "a.wav"
    path.write_bytes(LISTENER.read_bytes()[:64_001])
    assert len(sound_of(str(path))) == pytest.approx(64_000, abs=2 * CHUNK)


# A device that is none


class PretendedSound:
    """What `sounddevice` offers, without a microphone."""

    class PortAudioError(Exception):
        """As PortAudio's."""

    def __init__(self, fault: str = "") -> None:
        self._fault = fault
        self.callback: Callable[..., None] = print
        self.active = True

    def RawInputStream(self, **options: Any) -> PretendedSound:  # noqa: N802 - PortAudio's name
        assert (options["samplerate"], options["blocksize"]) == (16_000, CHUNK)
        if self._fault:
            raise self.PortAudioError(self._fault)
        self.callback = options["callback"]
        return self

    def start(self) -> None: ...

    def close(self) -> None:
        self.active = False


def test_a_device_is_heard_and_can_be_lost() -> None:
    pretended = PretendedSound()
    device = Device(None, pretended)
    device.open()
    for _ in range(1000):
        pretended.callback(bytes(CHUNK * 2), CHUNK, None, None)
    # What nobody listened to for ten seconds is dropped.
    assert 300 < len(list(device.chunks(0.0))) < 320
    pretended.active = False
    with pytest.raises(OSError, match="gives no more sound"):
        list(device.chunks(0.0))


def test_no_device() -> None:
    device = Device(7, PretendedSound("Error querying device 7"))
    with pytest.raises(PersonageError, match=r"microphone 7 cannot be opened .Error querying dev"):
        device.open()
