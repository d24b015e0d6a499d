package tellosimulator.view.replay;

import atlantafx.base.controls.Spacer;
import java.util.Optional;
import javafx.beans.property.Property;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.geometry.Orientation;
import javafx.scene.control.Separator;
import javafx.scene.control.ToolBar;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCombination;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import tellosimulator.scenery.orbit.RoomView;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.layout.BarButtons;
import tellosimulator.view.layout.LabeledToolBar;
import tellosimulator.view.layout.Theme;
import tellosimulator.view.model.SceneContext;
import tellosimulator.view.text.Messages;
import tellosimulator.view.world.GhostFlight;
import tellosimulator.view.world.Simulator3DScene;

/**
 * The content of the player: the room in the centre, the commands and events on the right, and the
 * slider at the bottom. Confined to the JavaFX thread.
 */
final class ReplayPane extends BorderPane {

  /**
   * Width of the panels on the right [px]. Decided: the room keeps two thirds of a small screen.
   */
  private static final double SIDE_WIDTH = 320;

  /** Step of the arrow keys without Shift [s]. Decided: the same as in reports. */
  private static final double STEP = 0.1;

  /** Step of the arrow keys with Shift [s]. Decided: the same as in reports. */
  private static final double LARGE_STEP = 1;

  private final Playback playback;
  private final Simulator3DScene world;
  private final EntryList entries;

  /** The display settings of the player's window. */
  record DisplaySettings(Property<Theme> theme, Property<Boolean> fullScreen) {}

  ReplayPane(FxReplay replay, GhostLoader ghosts, SceneContext context, DisplaySettings display) {
    playback = replay.playback();
    world = new ReplayScene(replay, context).scene();
    entries = new EntryList(replay, context.language());
    setId("replay-pane");
    Nodes.addCommonStyles(this);
    getStylesheets().add(ReplayPane.class.getResource("replay.css").toExternalForm());
    VBox side =
        Nodes.styled(
            new VBox(
                new ComparisonPanel(replay, ghosts, context.language()),
                new FlightReadout(replay, context),
                entries),
            "side");
    Nodes.fixWidth(side, SIDE_WIDTH);
    VBox.setVgrow(entries, Priority.ALWAYS);
    setTop(bar(context, display));
    world.dimmedProperty().bind(display.theme().map(theme -> theme == Theme.DARK));
    setCenter(world);
    setRight(side);
    setBottom(new TransportBar(replay, context.language(), entries));
  }

  private ToolBar bar(SceneContext context, DisplaySettings display) {
    BarButtons buttons = new BarButtons(context.language());
    ToolBar bar =
        new LabeledToolBar(
            buttons.camera(world),
            buttons.fit(world),
            buttons.follow(world),
            buttons.inset(world),
            buttons.trail(world),
            buttons.goalLine(world, new SimpleBooleanProperty(context.marks().asked())),
            new Spacer(),
            buttons.theme(display.theme()),
            new Separator(Orientation.VERTICAL),
            buttons.fullScreen(display.fullScreen()));
    bar.setId("replay-bar");
    return bar;
  }

  /** Returns the 3D scene. */
  Simulator3DScene world() {
    return world;
  }

  /** Returns the keyboard shortcuts. */
  ReplayKeys keys() {
    return new ReplayKeys()
        .on(KeyCode.SPACE, playback::toggle)
        .on(KeyCode.LEFT, () -> playback.step(-STEP))
        .on(KeyCode.RIGHT, () -> playback.step(STEP))
        .on(KeyCode.LEFT, () -> playback.step(-LARGE_STEP), KeyCombination.SHIFT_DOWN)
        .on(KeyCode.RIGHT, () -> playback.step(LARGE_STEP), KeyCombination.SHIFT_DOWN)
        .on(KeyCode.HOME, () -> playback.seek(playback.begin()))
        .on(KeyCode.END, () -> playback.seek(playback.end()))
        .on(KeyCode.PAGE_UP, () -> entries.jump(-1))
        .on(KeyCode.PAGE_DOWN, () -> entries.jump(1))
        .on(KeyCode.MINUS, () -> playback.faster(-1))
        .on(KeyCode.SUBTRACT, () -> playback.faster(-1))
        .on(KeyCode.PLUS, () -> playback.faster(1))
        .on(KeyCode.ADD, () -> playback.faster(1))
        .on(KeyCode.EQUALS, () -> playback.faster(1)) // the + key of US keyboards
        .on(KeyCode.EQUALS, () -> playback.faster(1), KeyCombination.SHIFT_DOWN)
        .on(KeyCode.DIGIT1, () -> world.look(RoomView.FRONT))
        .on(KeyCode.DIGIT2, () -> world.look(RoomView.SIDE))
        .on(KeyCode.DIGIT3, () -> world.look(RoomView.TOP))
        .on(KeyCode.DIGIT4, () -> world.look(RoomView.CHASE))
        .on(KeyCode.DIGIT5, world::switchCamera)
        .on(KeyCode.DIGIT6, () -> toggle(world.camera().followingProperty()))
        .on(KeyCode.DIGIT9, world::fit)
        .on(KeyCode.DIGIT0, () -> world.look(RoomView.START))
        .on(KeyCode.F6, () -> toggle(world.insetVisibleProperty()))
        .on(KeyCode.F7, () -> toggle(world.trailVisibleProperty()))
        .on(KeyCode.G, () -> toggle(world.goalLineVisibleProperty()));
  }

  static void toggle(Property<Boolean> property) {
    property.setValue(!property.getValue());
  }

  /**
   * Connects the 3D scene with a replay: shows its ghost, and redraws the trails after a jump.
   * Confined to the JavaFX thread.
   */
  private static final class ReplayScene {

    /**
     * Maximum interval between two frames that extends a trail; a longer one counts as a jump
     * [simulated s]. Decided: at 8 times the speed, a frame advances the playback by at most 2 s.
     */
    private static final double JUMP = 2.5;

    private final FxReplay replay;
    private final Messages messages;
    private final Simulator3DScene scene;
    private Optional<GhostFlight> ghost = Optional.empty();
    private double lastTime = Double.NaN;

    ReplayScene(FxReplay replay, SceneContext context) {
      this.replay = replay;
      messages = context.language().messages(ReplayScene.class);
      context.ticker().onTick(this::advance); // must run before the scene's own listener
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
              .map(
                  first -> new GhostFlight(first, FxReplay.GHOST_RGB, () -> messages.now("ghost")));
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
}
