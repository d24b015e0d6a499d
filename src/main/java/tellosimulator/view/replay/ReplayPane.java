package tellosimulator.view.replay;

import atlantafx.base.controls.Spacer;
import javafx.beans.property.Property;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.geometry.Orientation;
import javafx.scene.control.Separator;
import javafx.scene.control.ToolBar;
import javafx.scene.input.KeyCode;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import tellosimulator.view.fx.CommonStyles;
import tellosimulator.view.layout.BarButtons;
import tellosimulator.view.layout.LabeledToolBar;
import tellosimulator.view.layout.Theme;
import tellosimulator.view.model.SceneContext;
import tellosimulator.view.world.RoomView;
import tellosimulator.view.world.Simulator3DScene;

/**
 * The parts of the player: the room in the middle, what was commanded at the right, and the slider
 * over the flight below. For the JavaFX thread.
 */
final class ReplayPane extends BorderPane {

  /** Width of what is at the right [px]. Decided: the room keeps two thirds of a small screen. */
  private static final double SIDE_WIDTH = 320;

  /** How far an arrow key goes, without and with Shift [s]. Decided: as in reports. */
  private static final double STEP = 0.1;

  private static final double LARGE_STEP = 1;

  private final Playback playback;
  private final Simulator3DScene world;
  private final EntryList entries;

  /** How the player's window can look. */
  record DisplaySettings(Property<Theme> theme, Property<Boolean> fullScreen) {}

  ReplayPane(FxReplay replay, GhostLoader ghosts, SceneContext context, DisplaySettings display) {
    playback = replay.playback();
    world = new ReplayScene(replay, context).scene();
    entries = new EntryList(replay, context.language());
    setId("replay-pane");
    CommonStyles.install(this);
    getStylesheets().add(ReplayPane.class.getResource("replay.css").toExternalForm());
    VBox side =
        new VBox(
            new ComparisonPanel(replay, ghosts, context.language()),
            new FlightReadout(replay, context),
            entries);
    side.getStyleClass().add("side");
    side.setMinWidth(SIDE_WIDTH);
    side.setPrefWidth(SIDE_WIDTH);
    side.setMaxWidth(SIDE_WIDTH);
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

  /** The room. */
  Simulator3DScene world() {
    return world;
  }

  /** What keys do. */
  ReplayKeys keys() {
    return new ReplayKeys()
        .on(KeyCode.SPACE, playback::toggle)
        .on(KeyCode.LEFT, () -> playback.step(-STEP))
        .on(KeyCode.RIGHT, () -> playback.step(STEP))
        .onShift(KeyCode.LEFT, () -> playback.step(-LARGE_STEP))
        .onShift(KeyCode.RIGHT, () -> playback.step(LARGE_STEP))
        .on(KeyCode.HOME, () -> playback.seek(playback.begin()))
        .on(KeyCode.END, () -> playback.seek(playback.end()))
        .on(KeyCode.PAGE_UP, () -> entries.jump(-1))
        .on(KeyCode.PAGE_DOWN, () -> entries.jump(1))
        .on(KeyCode.MINUS, () -> playback.faster(-1))
        .on(KeyCode.SUBTRACT, () -> playback.faster(-1))
        .on(KeyCode.PLUS, () -> playback.faster(1))
        .on(KeyCode.ADD, () -> playback.faster(1))
        .on(KeyCode.EQUALS, () -> playback.faster(1)) // has the + of US keyboards
        .onShift(KeyCode.EQUALS, () -> playback.faster(1))
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
}
