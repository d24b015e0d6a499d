package tellosimulator.view.app;

import java.util.Map;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.DoubleProperty;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.SimpleDoubleProperty;
import javafx.util.Subscription;
import tellosimulator.math.Frames;
import tellosimulator.sim.Control;
import tellosimulator.view.controls.NetworkControls;
import tellosimulator.view.controls.SimulatorControls;
import tellosimulator.view.log.LogPane;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.settings.SettingCodec;
import tellosimulator.view.settings.Settings;
import tellosimulator.view.world.Simulator3DScene;
import tellosimulator.world.Decor;

/** Saves and restores the settings of a window's parts. Confined to the JavaFX thread. */
record WindowSettings(
    ViewContext context,
    Simulator3DScene world,
    LogPane log,
    SimulatorControls simulatorControls,
    NetworkControls networkControls) {

  /**
   * The key of the setting that enlarges distant drones. The player of recordings uses this
   * setting, too.
   */
  static final String ENLARGED_DRONES = "show.enlarged-drones";

  /** The key of the setting for the grid's size [cm]. */
  private static final String GRID = "grid-cm";

  /**
   * Restores the parts from the settings, and saves their changes until the subscription ends. The
   * size of the grid is included only if the window shows the default room.
   */
  Subscription remember(Settings settings) {
    Subscription bound =
        simulatorControls.remember(settings).and(networkControls.remember(settings));
    for (Map.Entry<String, BooleanProperty> flag : flags().entrySet()) {
      bound = bound.and(settings.bind(flag.getKey(), flag.getValue(), SettingCodec.flag()));
    }
    return context.scenario().plain() ? bound.and(rememberGrid(settings)) : bound;
  }

  /** Returns the boolean settings by their keys. */
  private Map<String, BooleanProperty> flags() {
    return Map.of(
        "show.trail",
        world.trailVisibleProperty(),
        "show.goal-line",
        world.goalLineVisibleProperty(),
        "show.inset",
        world.insetVisibleProperty(),
        "show.inset-enlarged",
        world.insetEnlargedProperty(),
        ENLARGED_DRONES,
        world.dronesEnlargedProperty(),
        "show.smooth-edges",
        world.antialiasingProperty(),
        "log.time-stamps",
        log.timeStampsProperty());
  }

  private Subscription rememberGrid(Settings settings) {
    ReadOnlyObjectProperty<Decor> decor = context.simulation().decorProperty();
    DoubleProperty gridCm = new SimpleDoubleProperty(gridCm(decor.get()));
    Subscription bound =
        settings.bind(
            GRID,
            gridCm,
            SettingCodec.decimal(
                Frames.centimeters(Decor.SMALLEST_GRID), Frames.centimeters(Decor.LARGEST_GRID)));
    if (gridCm.get() != gridCm(decor.get())) {
      Decor remembered = decor.get().withGrid(Frames.meters(gridCm.get()));
      context.actions().carryOut(new Control.Decorate(remembered));
    }
    decor.addListener((property, before, now) -> gridCm.set(gridCm(now)));
    return bound;
  }

  /** Returns the size of the grid without the rounding errors of the conversion [cm]. */
  private static double gridCm(Decor decor) {
    return Math.rint(Frames.centimeters(decor.grid()) * 1000) / 1000;
  }
}
