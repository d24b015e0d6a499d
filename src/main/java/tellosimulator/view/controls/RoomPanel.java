package tellosimulator.view.controls;

import java.util.List;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.sim.Control;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Messages;
import tellosimulator.world.Decor;
import tellosimulator.world.Room;

/**
 * The room's size, its grid, and where the selected drone starts; all in centimetres. What a person
 * changes goes to the simulation at once, or at the next pulse while it has something to do, and
 * what the simulation says is shown. For the JavaFX thread.
 */
final class RoomPanel extends Card {

  /** What a slider reaches [cm]. Decided: from the smallest room to a gym. */
  private static final NumberRange SLIDER =
      new NumberRange(Frames.centimeters(Room.SHORTEST), 2000, 10);

  private static final NumberRange FIELD =
      new NumberRange(
          Frames.centimeters(Room.SHORTEST), Frames.centimeters(Room.LONGEST), SLIDER.step());

  /** Distance between the grid's lines [cm]. */
  private static final NumberRange GRID =
      new NumberRange(
          Frames.centimeters(Decor.SMALLEST_GRID), Frames.centimeters(Decor.LARGEST_GRID), 5);

  /** By how much an arrow key moves the start [cm]. */
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
    context.pulse().onBeat(nanos -> beat());
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
        .subscribe(asked -> setUseful(asked.goals().isEmpty())); // a task has its own room
  }

  /** What was typed was meant for the other drone. */
  private void forgetStart() {
    startX.forgetTyped();
    startY.forgetTyped();
    showStart();
  }

  /** So that the next picture shows it already; a drag sends no more than that. */
  private void sendAtOnce() {
    if (!actions.pending()) {
      beat();
    }
  }

  /** What the simulation does not have yet is not shown as it was before. */
  private void beat() {
    if (changed(width, depth, height)) {
      actions.carryOut(new Control.SetRoom(wantedRoom()));
    } else if (!actions.pending()) {
      showRoom();
    }
    if (changed(grid)) {
      actions.carryOut(new Control.Decorate(wantedDecor()));
    } else if (!actions.pending()) {
      showGrid();
    }
    if (changed(startX, startY)) {
      actions.carryOut(
          new Control.SetStart(simulation.selected().number(), wantedStart(), startHeading()));
    } else if (!actions.pending()) {
      showStart();
    }
  }

  /** Whether a person changed one of them; then all of them count as taken. */
  private static boolean changed(NumberSlider... sliders) {
    boolean changed = false;
    for (NumberSlider slider : sliders) {
      changed |= slider.takeChange();
    }
    return changed;
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

  private Room wantedRoom() {
    return new Room(
        Frames.meters(width.value()), Frames.meters(depth.value()), Frames.meters(height.value()));
  }

  private Decor wantedDecor() {
    return simulation.decorProperty().get().withGrid(Frames.meters(grid.value()));
  }

  private Vec3 wantedStart() {
    return new Vec3(Frames.meters(startX.value()), Frames.meters(startY.value()), 0);
  }

  private double startHeading() {
    return simulation.selected().startProperty().get().attitude().heading();
  }

  private Room room() {
    return simulation.roomProperty().get();
  }

  /** Where a drone can stand between two walls; rounded inwards to what a field shows. */
  private static NumberRange startRange(double edge) {
    double reach = Frames.centimeters(edge / 2 - DroneSpec.COLLIDER.radius());
    double shown = Math.floor(reach * 10 + 1e-6) / 10;
    return new NumberRange(-shown, shown, START_STEP);
  }
}
