package tellosimulator.view.replay;

import java.util.Optional;
import tellosimulator.view.model.SceneContext;
import tellosimulator.view.text.Messages;
import tellosimulator.view.world.GhostFlight;
import tellosimulator.view.world.Simulator3DScene;

/**
 * Lets the 3D scene show the moment of a replay: its ghost, and the trails of what was flown until
 * then, also after a jump. For the JavaFX thread.
 */
final class ReplayScene {

  /** A longer way from frame to frame is a jump, not a trail [s]. Decided: 8 times as fast. */
  private static final double JUMP = 2.5;

  private final FxReplay replay;
  private final Messages messages;
  private final Simulator3DScene scene;
  private Optional<GhostFlight> ghost = Optional.empty();
  private double lastTime = Double.NaN;

  ReplayScene(FxReplay replay, SceneContext context) {
    this.replay = replay;
    messages = context.language().messages(ReplayScene.class);
    context.pulse().onBeat(this::advance); // before the scene, which shows what comes of it
    scene = new Simulator3DScene(context);
    replay.ghostProperty().subscribe(now -> changeGhost());
  }

  Simulator3DScene scene() {
    return scene;
  }

  private void changeGhost() {
    ghost =
        replay
            .ghostSnapshot()
            .map(first -> new GhostFlight(first, FxReplay.GHOST_RGB, () -> messages.now("ghost")));
    scene.setGhost(ghost);
    lastTime = Double.NaN;
  }

  private void advance(long nanos) {
    replay.advance(nanos);
    double time = replay.playback().time();
    boolean goesOn = time >= lastTime && time - lastTime <= JUMP;
    if (!goesOn) {
      scene.retrace(replay.past());
      ghost.ifPresent(other -> other.retrace(replay.ghostPast()));
    }
    lastTime = time;
    replay.ghostSnapshot().ifPresent(now -> ghost.ifPresent(other -> other.show(now)));
  }
}
