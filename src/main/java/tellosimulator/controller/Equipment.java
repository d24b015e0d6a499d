package tellosimulator.controller;

import tellosimulator.extension.LightOrder;
import tellosimulator.model.DroneModel;
import tellosimulator.model.PadMode;
import tellosimulator.model.VideoSettings;
import tellosimulator.profile.Profile;
import tellosimulator.profile.Sdk;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/**
 * The camera, the pad detector and the extension board of a drone. Confined to the simulation
 * thread.
 */
final class Equipment {

  private final DroneModel model;
  private final Profile profile;

  Equipment(DroneModel model, Profile profile) {
    this.model = model;
    this.profile = profile;
  }

  Result detectPads(boolean on) {
    boolean both = profile.sdk() == Sdk.SDK_2_0;
    PadMode mode = both ? PadMode.BOTH : PadMode.DOWN;
    model.look(on ? mode : PadMode.OFF);
    return Result.DONE;
  }

  Result setPadDirection(int direction) {
    if (model.perception().padMode() == PadMode.OFF) {
      return new Result.Refused(
          RefusalKind.GENERAL, Phrase.of("pad detection is off, send `mon` first"));
    }
    PadMode[] modes = {PadMode.DOWN, PadMode.FORWARD, PadMode.BOTH};
    model.look(modes[direction]);
    return Result.DONE;
  }

  Result stream(boolean on) {
    VideoSettings video = model.video();
    model.setVideo(on ? video.started() : video.stopped());
    return Result.DONE;
  }

  void sendKeyPicture() {
    model.setVideo(model.video().withKeyPicture());
  }

  Result light(LightOrder order, SimTime now) {
    model.setLights(model.lights().after(order, now));
    return Result.DONE;
  }

  Result setVideo(VideoOption option, int value) {
    VideoSettings video = model.video();
    model.setVideo(
        switch (option) {
          case FRAMES_PER_SECOND -> video.withFramesPerSecond(value);
          case BIT_RATE -> video.withMegabits(value);
          case LINES -> video.withLines(value);
          case WIDE -> video.withWide(value == 1);
          case DOWNWARD -> video.withDownward(value == 1);
        });
    return Result.DONE;
  }
}
