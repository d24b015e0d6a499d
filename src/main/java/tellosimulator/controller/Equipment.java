package tellosimulator.controller;

import tellosimulator.command.Command;
import tellosimulator.command.OperatorSession;
import tellosimulator.command.Reply;
import tellosimulator.command.Responder;
import tellosimulator.model.DroneModel;
import tellosimulator.model.PadMode;
import tellosimulator.model.VideoSettings;
import tellosimulator.profile.Profile;
import tellosimulator.profile.Sdk;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/**
 * The commands for what a drone carries: camera, pad detector and extension board. For the
 * simulation thread.
 */
final class Equipment {

  private final DroneModel model;
  private final Profile profile;
  private final OperatorSession session;
  private final FlightObserver observer;

  Equipment(DroneModel model, Profile profile, OperatorSession session, FlightObserver observer) {
    this.model = model;
    this.profile = profile;
    this.session = session;
    this.observer = observer;
  }

  void detectPads(Command.DetectPads command, Responder responder) {
    boolean both = profile.sdk() == Sdk.SDK_2_0;
    PadMode mode = both ? PadMode.BOTH : PadMode.DOWN;
    model.look(command.on() ? mode : PadMode.OFF);
    responder.reply(Reply.OK);
  }

  void setPadDirection(Command.SetPadDirection command, Responder responder) {
    if (model.perception().padMode() == PadMode.OFF) {
      responder.refuse(Reply.ERROR, Phrase.of("pad detection is off, send `mon` first"));
      return;
    }
    PadMode[] modes = {PadMode.DOWN, PadMode.FORWARD, PadMode.BOTH};
    model.look(modes[command.direction()]);
    responder.reply(Reply.OK);
  }

  void stream(Command.Stream command, Responder responder) {
    VideoSettings video = model.video();
    model.setVideo(command.on() ? video.started() : video.stopped());
    observer.happened(
        new FlightEvent.Note(
            command.on()
                ? Phrase.of("films for port %d of its operator", session.link().videoPort())
                : Phrase.of("films no more")));
    responder.reply(Reply.OK);
  }

  void light(Command.Light command, Responder responder, SimTime now) {
    model.setLights(model.lights().after(command.order(), now));
    responder.reply(command.reply());
  }

  void setVideo(Command.SetVideo command, Responder responder) {
    VideoSettings video = model.video();
    int value = command.value();
    model.setVideo(
        switch (command.option()) {
          case FRAMES_PER_SECOND -> video.withFramesPerSecond(value);
          case BIT_RATE -> video.withMegabits(value);
          case LINES -> video.withLines(value);
          case DOWNWARD -> video.withDownward(value == 1);
        });
    responder.reply(Reply.OK);
  }
}
