package tellosimulator.view.app;

import java.util.Map;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.DoubleProperty;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.SimpleDoubleProperty;
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

/** What is remembered of the parts of a window, and by which keys. For the JavaFX thread. */
final class WindowSettings {

  /** The setting that draws distant drones larger, which the player has, too. */
  static final String ENLARGED_DRONES = "show.enlarged-drones";

  /** The setting of the grid [cm]. */
  private static final String GRID = "grid-cm";

  private final ViewContext context;
  private final Simulator3DScene world;
  private final LogPane log;
  private final SimulatorControls simulatorControls;
  private final NetworkControls networkControls;

  WindowSettings(
      ViewContext context,
      Simulator3DScene world,
      LogPane log,
      SimulatorControls simulatorControls,
      NetworkControls networkControls) {
    this.context = context;
    this.world = world;
    this.log = log;
    this.simulatorControls = simulatorControls;
    this.networkControls = networkControls;
  }

  /** Lets the parts be at first as they were left, and remembers how they are left. */
  void remember(Settings settings) {
    flags().forEach((key, flag) -> settings.bind(key, flag, SettingCodec.flag()));
    simulatorControls.remember(settings);
    networkControls.remember(settings);
    if (context.scenario().plain()) {
      rememberGrid(settings);
    }
  }

  /** What is remembered, by its key. */
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

  /** Lets another window of the same program remember. */
  void forget(Settings settings) {
    flags().keySet().forEach(settings::unbind);
    settings.unbind(GRID);
    simulatorControls.forget(settings);
    networkControls.forget(settings);
  }

  private void rememberGrid(Settings settings) {
    ReadOnlyObjectProperty<Decor> decor = context.simulation().decorProperty();
    DoubleProperty gridCm = new SimpleDoubleProperty(gridCm(decor.get()));
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
  }

  /** The grid as people see it, without the last bits of the conversion. */
  private static double gridCm(Decor decor) {
    return Math.rint(Frames.centimeters(decor.grid()) * 1000) / 1000;
  }
}
