package tellosimulator.command;

import tellosimulator.board.LightOrder;
import tellosimulator.math.Arc;
import tellosimulator.math.Vec3;

/**
 * A command that was understood and whose parameters are in range. Units are SI, axes those of the
 * level body frame (x along the nose, y to the left, z up), unless a component says otherwise.
 */
public sealed interface Command {

  /** Calls the one method of {@code target} that carries this command out. */
  void on(CommandTarget target, Responder responder);

  /** {@code command}. */
  record EnterSdkMode() implements Command {
    @Override
    public void on(CommandTarget target, Responder responder) {
      target.enterSdkMode(this, responder);
    }
  }

  /** {@code takeoff} and {@code throwfly}. */
  record Takeoff() implements Command {
    @Override
    public void on(CommandTarget target, Responder responder) {
      target.takeoff(this, responder);
    }
  }

  /** {@code land}. */
  record Land() implements Command {
    @Override
    public void on(CommandTarget target, Responder responder) {
      target.land(this, responder);
    }
  }

  /** {@code stop}. */
  record Stop() implements Command {
    @Override
    public void on(CommandTarget target, Responder responder) {
      target.stop(this, responder);
    }
  }

  /** {@code emergency}. */
  record Emergency() implements Command {
    @Override
    public void on(CommandTarget target, Responder responder) {
      target.emergency(this, responder);
    }
  }

  /**
   * {@code up down left right forward back}.
   *
   * @param distance metres
   */
  record Move(Direction direction, double distance) implements Command {
    @Override
    public void on(CommandTarget target, Responder responder) {
      target.move(this, responder);
    }
  }

  /**
   * {@code cw} and {@code ccw}.
   *
   * @param angle radians, counter-clockwise seen from above, as many turns as one likes
   */
  record Turn(double angle) implements Command {
    @Override
    public void on(CommandTarget target, Responder responder) {
      target.turn(this, responder);
    }
  }

  /**
   * {@code flip}.
   *
   * @param direction not up or down
   */
  record Flip(Direction direction) implements Command {
    @Override
    public void on(CommandTarget target, Responder responder) {
      target.flip(this, responder);
    }
  }

  /**
   * {@code go}.
   *
   * @param way from here to the goal [m]
   * @param speed metres per second
   */
  record Go(Vec3 way, double speed) implements Command {
    @Override
    public void on(CommandTarget target, Responder responder) {
      target.go(this, responder);
    }
  }

  /**
   * {@code curve}.
   *
   * @param arc from here, metres
   * @param speed metres per second
   */
  record Curve(Arc arc, double speed) implements Command {
    @Override
    public void on(CommandTarget target, Responder responder) {
      target.curve(this, responder);
    }
  }

  /**
   * {@code go} with a mission pad.
   *
   * @param goal in the pad's frame [m]
   * @param speed metres per second
   */
  record GoToPad(Vec3 goal, double speed, PadChoice pad) implements Command {
    @Override
    public void on(CommandTarget target, Responder responder) {
      target.goToPad(this, responder);
    }
  }

  /**
   * {@code curve} with a mission pad.
   *
   * @param via in the pad's frame [m]
   * @param end in the pad's frame [m]
   * @param speed metres per second
   */
  record CurveOverPad(Vec3 via, Vec3 end, double speed, PadChoice pad) implements Command {
    @Override
    public void on(CommandTarget target, Responder responder) {
      target.curveOverPad(this, responder);
    }
  }

  /**
   * {@code jump}.
   *
   * @param leg where to go over the first pad, then how fast
   * @param heading at the end, in the second pad's frame [rad], counter-clockwise
   */
  record Jump(GoToPad leg, double heading, PadChoice second) implements Command {
    @Override
    public void on(CommandTarget target, Responder responder) {
      target.jump(this, responder);
    }
  }

  /**
   * {@code speed}.
   *
   * @param speed metres per second
   */
  record SetSpeed(double speed) implements Command {
    @Override
    public void on(CommandTarget target, Responder responder) {
      target.setSpeed(this, responder);
    }
  }

  /** {@code rc}. */
  record Rc(Sticks sticks) implements Command {
    @Override
    public void on(CommandTarget target, Responder responder) {
      target.rc(this, responder);
    }
  }

  /**
   * {@code wifi ap multiwifi wifisetchannel}: a simulator has no Wi-Fi.
   *
   * @param done the real drone's reply
   */
  record SetNetwork(Reply done) implements Command {
    @Override
    public void on(CommandTarget target, Responder responder) {
      target.setNetwork(this, responder);
    }
  }

  /** {@code mon} and {@code moff}. */
  record DetectPads(boolean on) implements Command {
    @Override
    public void on(CommandTarget target, Responder responder) {
      target.detectPads(this, responder);
    }
  }

  /**
   * Chooses where to look for pads.
   *
   * @param direction 0 down, 1 forward, 2 both
   */
  record SetPadDirection(int direction) implements Command {
    @Override
    public void on(CommandTarget target, Responder responder) {
      target.setPadDirection(this, responder);
    }
  }

  /** {@code streamon} and {@code streamoff}. */
  record Stream(boolean on) implements Command {
    @Override
    public void on(CommandTarget target, Responder responder) {
      target.stream(this, responder);
    }
  }

  /** {@code setfps setbitrate setresolution downvision}. */
  record SetVideo(VideoOption option, int value) implements Command {
    @Override
    public void on(CommandTarget target, Responder responder) {
      target.setVideo(this, responder);
    }
  }

  /** {@code port}. */
  record SetPorts(int statePort, int videoPort) implements Command {
    @Override
    public void on(CommandTarget target, Responder responder) {
      target.setPorts(this, responder);
    }
  }

  /** {@code motoron} and {@code motoroff}. */
  record SpinMotors(boolean on) implements Command {
    @Override
    public void on(CommandTarget target, Responder responder) {
      target.spinMotors(this, responder);
    }
  }

  /** {@code reboot}. */
  record Reboot() implements Command {
    @Override
    public void on(CommandTarget target, Responder responder) {
      target.reboot(this, responder);
    }
  }

  /** {@code EXT led} and {@code EXT mled}. */
  record Light(LightOrder order, Reply reply) implements Command {
    @Override
    public void on(CommandTarget target, Responder responder) {
      target.light(this, responder);
    }
  }

  /** A command that only has to be acknowledged, such as {@code keepalive}. */
  record Acknowledge(Reply reply) implements Command {
    @Override
    public void on(CommandTarget target, Responder responder) {
      target.acknowledge(this, responder);
    }
  }

  /** Every command that ends with a question mark. */
  record Read(Reading reading) implements Command {
    @Override
    public void on(CommandTarget target, Responder responder) {
      target.read(this, responder);
    }
  }
}
