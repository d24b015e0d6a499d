package tellosimulator.view.app;

import javafx.beans.property.BooleanProperty;
import javafx.stage.Stage;
import javafx.stage.WindowEvent;
import tellosimulator.scenery.orbit.RoomView;
import tellosimulator.sim.Control;
import tellosimulator.view.layout.KeyBindings;
import tellosimulator.view.layout.WindowKey;
import tellosimulator.view.layout.WindowState;
import tellosimulator.view.layout.WindowState.Flag;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.video.VideoCapture;

/** The keys of the simulator's window and their actions. Confined to the JavaFX thread. */
record WindowKeys(SimulatorWindow window, ViewContext context, WindowState state, Stage stage) {

  /** Returns the table of keys. */
  KeyBindings bindings() {
    KeyBindings keys = new KeyBindings();
    for (RoomView view : RoomView.values()) {
      keys.on(WindowKey.of(view), () -> window.world().look(view));
    }
    return keys.on(WindowKey.HELP, window.pages()::toggleHelp)
        .on(WindowKey.SIMULATOR_CONTROLS, () -> state.toggle(Flag.SIMULATOR_CONTROLS))
        .on(WindowKey.NETWORK_CONTROLS, () -> state.toggle(Flag.NETWORK_CONTROLS))
        .on(WindowKey.LOG, () -> state.toggle(Flag.LOG))
        .on(WindowKey.DRONES, () -> state.toggle(Flag.DRONES))
        .on(WindowKey.INSET, () -> toggle(window.world().insetVisibleProperty()))
        .on(WindowKey.STILL, () -> capture().saveStill())
        .on(WindowKey.PROJECTOR, () -> state.toggle(Flag.PROJECTOR))
        .on(WindowKey.RECORD, () -> capture().toggleRecording())
        .on(WindowKey.TRAIL, () -> toggle(window.world().trailVisibleProperty()))
        .on(WindowKey.GOAL_LINE, () -> toggle(window.world().goalLineVisibleProperty()))
        .on(WindowKey.PAUSE, context.actions()::togglePause)
        .on(WindowKey.PLAN, () -> state.toggle(Flag.PLAN))
        .on(WindowKey.FULL_SCREEN, () -> state.toggle(Flag.FULL_SCREEN))
        .on(WindowKey.FIT, window.world()::fit)
        .on(WindowKey.FOLLOW, () -> toggle(window.world().camera().followingProperty()))
        .on(WindowKey.DRONE_CAMERA, window.world()::switchCamera)
        .on(WindowKey.NEXT_DRONE, () -> context.simulation().selectNext(1))
        .on(WindowKey.PREVIOUS_DRONE, () -> context.simulation().selectNext(-1))
        .on(WindowKey.GALLERY, context.scenario().actions()::choose)
        .on(WindowKey.OPEN_SCENARIO, window.files()::chooseToOpen)
        .on(WindowKey.SAVE_SCENARIO, window.files()::save)
        .on(WindowKey.SAVE_SCENARIO_AS, window.files()::chooseToSave)
        .on(WindowKey.RELOAD_SCENARIO, context.scenario().actions()::reload)
        .on(WindowKey.AGAIN, window::again)
        .on(WindowKey.NEXT_GROUP, this::nextGroup)
        .on(WindowKey.SEARCH_LOG, window.log()::startSearch)
        .on(WindowKey.QUIT, this::quit);
  }

  /** Requests that the window be closed, like the close button in the window's frame. */
  private void quit() {
    stage.fireEvent(new WindowEvent(stage, WindowEvent.WINDOW_CLOSE_REQUEST));
  }

  private static void toggle(BooleanProperty property) {
    property.set(!property.get());
  }

  /** Returns the object that saves stills and recordings of the selected drone's video. */
  private VideoCapture capture() {
    return context.video().capture(context.simulation().selected().number());
  }

  /**
   * Prepares the simulator for the next group of users: resets the drones, releases them from their
   * operators, charges their batteries, clears their paths and the log, and restarts the clock of
   * the projector view.
   */
  void nextGroup() {
    for (FxDroneModel drone : context.simulation().drones()) {
      context.actions().carryOut(new Control.Reset(drone.number()));
      context.actions().carryOut(new Control.Release(drone.number()));
      context.actions().carryOut(new Control.SetBattery(drone.number(), 100));
    }
    context
        .actions()
        .afterPending(
            () -> {
              window.world().clearTrails();
              window.log().clear();
              window.restartClock();
            });
  }
}
