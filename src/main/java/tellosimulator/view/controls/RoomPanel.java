package tellosimulator.view.controls;

import java.util.List;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.scenario.Quantity;
import tellosimulator.sim.Control;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Messages;
import tellosimulator.world.Room;

/**
 * Controls for the room's size, its grid, and the start of the selected drone, in centimetres.
 * Changes are sent to the simulation immediately, or at the next pulse if actions are pending. The
 * panel shows the values of the simulation. Confined to the JavaFX thread.
 */
final class RoomPanel extends Card {

  /**
   * The range of the sliders for the size of the room [cm]. Decided: from the smallest room to a
   * gym.
   */
  private static final NumberRange SLIDER = new NumberRange(Quantity.ROOM_EDGE.least(), 2000, 10);

  private static final NumberRange FIELD = new NumberRange(Quantity.ROOM_EDGE, SLIDER.step());

  private static final NumberRange GRID = new NumberRange(Quantity.GRID, 5);

  /** The amount by which an arrow key moves the start [cm]. */
  private static final double START_STEP = 10;

  private final FxSimulation simulation;
  private final SimulatorActions actions;
  private final NumberSlider width;
  private final NumberSlider depth;
  private final NumberSlider height;
  private final NumberSlider grid;
  private final NumberSlider startX;
  private final NumberSlider startY;

  RoomPanel(ViewContext context) {
    super("room", context.language().messages(RoomPanel.class).text("room.heading"));
    simulation = context.simulation();
    actions = context.actions();
    width = slider(context, "room-width", SLIDER);
    depth = slider(context, "room-depth", SLIDER);
    height = slider(context, "room-height", SLIDER);
    grid = slider(context, "grid-size", GRID);
    startX = slider(context, "start-x", startRange(room().depth()));
    startY = slider(context, "start-y", startRange(room().width()));
    initializeParts();
    layoutCard(width, depth, height, grid, startX, startY);
    setupBindings(context);
    context.ticker().onTick(nanos -> beat());
  }

  private static NumberSlider slider(ViewContext context, String id, NumberRange range) {
    Messages messages = context.language().messages(RoomPanel.class);
    return new NumberSlider(id, messages.text(id), range, context.language());
  }

  private void initializeParts() {
    List.of(width, depth, height).forEach(edge -> edge.setFieldRange(FIELD));
    showRoom();
    showGrid();
    showStart();
  }

  private void setupBindings(ViewContext context) {
    simulation.selectedProperty().addListener((property, before, now) -> forgetStart());
    for (NumberSlider slider : List.of(width, depth, height, grid, startX, startY)) {
      slider.onChange(this::sendAtOnce);
    }
    context
        .scenario()
        .challengeProperty()
        .subscribe(asked -> setUseful(asked.goals().isEmpty())); // goals depend on the room
  }

  /** Discards typed text, because it was meant for the previous drone. */
  private void forgetStart() {
    startX.forgetTyped();
    startY.forgetTyped();
    showStart();
  }

  /**
   * Sends a change without waiting for the next pulse, so that the next frame shows it. Does
   * nothing while actions are pending, so that a drag sends no additional messages.
   */
  private void sendAtOnce() {
    if (!actions.pending()) {
      beat();
    }
  }

  /**
   * Sends changes if there are any, and otherwise shows the current values. The display is not
   * updated while actions are pending, because the values are then outdated.
   */
  private void beat() {
    NumberSlider.advance(actions, this::wantedRoom, this::showRoom, width, depth, height);
    NumberSlider.advance(actions, this::wantedDecor, this::showGrid, grid);
    NumberSlider.advance(actions, this::wantedStart, this::showStart, startX, startY);
  }

  private void showRoom() {
    width.show(Frames.centimeters(room().width()));
    depth.show(Frames.centimeters(room().depth()));
    height.show(Frames.centimeters(room().height()));
    startX.setRange(startRange(room().depth()));
    startY.setRange(startRange(room().width()));
  }

  private void showGrid() {
    grid.show(Frames.centimeters(simulation.decorProperty().get().grid()));
  }

  private void showStart() {
    Vec3 start = simulation.selected().startProperty().get().position();
    startX.show(Frames.centimeters(start.x()));
    startY.show(Frames.centimeters(start.y()));
  }

  private Control wantedRoom() {
    return new Control.SetRoom(
        new Room(
            Frames.meters(width.value()),
            Frames.meters(depth.value()),
            Frames.meters(height.value())));
  }

  private Control wantedDecor() {
    return new Control.Decorate(
        simulation.decorProperty().get().withGrid(Frames.meters(grid.value())));
  }

  private Control wantedStart() {
    return new Control.SetStart(
        simulation.selected().number(),
        new Vec3(Frames.meters(startX.value()), Frames.meters(startY.value()), 0),
        simulation.selected().startProperty().get().attitude().heading());
  }

  private Room room() {
    return simulation.roomProperty().get();
  }

  /**
   * Returns the range of start positions between two opposite walls [cm], rounded inwards to the
   * precision of a field.
   *
   * @param edge the distance between the walls [m]
   */
  private static NumberRange startRange(double edge) {
    double reach = Frames.centimeters(edge / 2 - DroneSpec.COLLIDER.radius());
    double shown = Math.floor(reach * 10 + 1e-6) / 10;
    return new NumberRange(-shown, shown, START_STEP);
  }
}
