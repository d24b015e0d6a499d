package tellosimulator.controller;

import tellosimulator.extension.LightOrder;
import tellosimulator.model.DroneModel;
import tellosimulator.model.PadMode;
import tellosimulator.model.VideoOption;
import tellosimulator.model.VideoSettings;
import tellosimulator.profile.Profile;
import tellosimulator.profile.Sdk;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/**
 * The camera, the pad detector and the extension board of a drone. Confined to the simulation
 * thread.
 */
public final class Equipment {

  private final DroneModel model;
  private final Profile profile;

  Equipment(DroneModel model, Profile profile) {
    this.model = model;
    this.profile = profile;
  }

  public Result detectPads(boolean on) {
    boolean both = profile.sdk() == Sdk.SDK_2_0;
    PadMode mode = both ? PadMode.BOTH : PadMode.DOWN;
    model.look(on ? mode : PadMode.OFF);
    return Result.DONE;
  }

  /**
   * Sets the directions in which the drone detects mission pads.
   *
   * @param direction 0 down, 1 forward, 2 both
   */
  public Result setPadDirection(int direction) {
    if (model.perception().padMode() == PadMode.OFF) {
      return new Result.Refused(
          RefusalKind.GENERAL, Phrase.of("pad detection is off, send `mon` first"));
    }
    PadMode[] modes = {PadMode.DOWN, PadMode.FORWARD, PadMode.BOTH};
    model.look(modes[direction]);
    return Result.DONE;
  }

  public Result stream(boolean on) {
    VideoSettings video = model.video();
    model.setVideo(on ? video.started() : video.stopped());
    return Result.DONE;
  }

  /** Makes the next picture one with which a decoder can begin. */
  public void sendKeyPicture() {
    model.setVideo(model.video().withKeyPicture());
  }

  /** Gives an order to the lights of the extension board. */
  public Result light(LightOrder order, SimTime now) {
    model.setLights(model.lights().after(order, now));
    return Result.DONE;
  }

  public Result setVideo(VideoOption option, int value) {
    model.setVideo(model.video().with(option, value));
    return Result.DONE;
  }
}
