package tellosimulator.view.layout;

import atlantafx.base.controls.Spacer;
import atlantafx.base.theme.Styles;
import javafx.geometry.Orientation;
import javafx.scene.control.Separator;
import javafx.scene.control.ToggleButton;
import org.kordamp.ikonli.feather.Feather;
import tellosimulator.view.controls.LinkButton;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Language;
import tellosimulator.view.world.Simulator3DScene;

/** The bar at the top: from where one looks, how one flies, and how the window looks. */
public final class WindowBar extends LabeledToolBar {

  private final BarButtons buttons;
  private final WindowState state;
  private final ScenarioMenu scenarios;

  public WindowBar(
      ViewContext context, WindowState state, Simulator3DScene scene, PageOverlay pages) {
    this.scenarios = new ScenarioMenu(context);
    this.buttons = new BarButtons(context.language());
    this.state = state;
    setId("window-bar");
    getItems()
        .setAll(
            buttons.button("scenarios", Feather.FOLDER, context.scenario().actions()::choose),
            scenarios,
            new Separator(Orientation.VERTICAL),
            buttons.camera(scene),
            buttons.fit(scene),
            buttons.follow(scene),
            new Separator(Orientation.VERTICAL),
            buttons.inset(scene),
            buttons.trail(scene),
            buttons.goalLine(
                scene,
                context.scenario().challengeProperty().map(asked -> !asked.goals().isEmpty())),
            drones(context),
            buttons.toggle("show-plan", Feather.MAP, state.planShownProperty()),
            new Spacer(),
            new SettingsMenu(context.language(), state, scene, pages),
            buttons.button("help", Feather.HELP_CIRCLE, pages::toggleHelp),
            new Separator(Orientation.VERTICAL),
            buttons.part("show-controls", Feather.SLIDERS, state.simulatorControlsShownProperty()),
            buttons.part("show-log", Feather.TERMINAL, state.logOpenProperty()),
            new Separator(Orientation.VERTICAL),
            link(context));
  }

  /** The menu of files. */
  public ScenarioMenu scenarios() {
    return scenarios;
  }

  /** Adds a menu of all commands. */
  public void addMenu(Language language, WindowCommands commands) {
    getItems().add(0, new CommandMenu(language, commands));
  }

  /** Is large, for it is what a program needs to know. */
  private LinkButton link(ViewContext context) {
    LinkButton button = new LinkButton(context, state.networkControlsShownProperty());
    button.getStyleClass().addAll(Styles.FLAT, Styles.SMALL);
    return button;
  }

  private ToggleButton drones(ViewContext context) {
    ToggleButton button = buttons.toggle("show-drones", Feather.LIST, state.dronesShownProperty());
    boolean several = context.simulation().drones().size() > 1;
    button.setVisible(several);
    button.setManaged(several);
    return button;
  }
}
