package tellosimulator.view.layout;

import atlantafx.base.controls.Spacer;
import atlantafx.base.theme.Styles;
import javafx.beans.property.Property;
import javafx.geometry.Orientation;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.ButtonBase;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.Separator;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.ToolBar;
import javafx.scene.layout.HBox;
import org.kordamp.ikonli.Ikon;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Messages;
import tellosimulator.view.world.Simulator3DScene;
import tellosimulator.view.world.ViewCamera;

/** The bar at the top: from where one looks, how one flies, and how the window looks. */
public final class WindowBar extends ToolBar {

  private final Messages messages;
  private final WindowState state;
  private final Simulator3DScene scene;
  private final ScenarioMenu scenarios;

  public WindowBar(
      ViewContext context, WindowState state, Simulator3DScene scene, PageOverlay pages) {
    this.scenarios = new ScenarioMenu(context);
    this.messages = context.language().messages(WindowBar.class);
    this.state = state;
    this.scene = scene;
    setId("window-bar");
    getItems()
        .setAll(
            scenarios,
            toggle("show-controls", Feather.SLIDERS, state.simulatorControlsShownProperty()),
            new Separator(Orientation.VERTICAL),
            views(),
            droneCamera(),
            toggle("show-inset", Feather.IMAGE, scene.insetVisibleProperty()),
            toggle("show-trail", Feather.ACTIVITY, scene.trailVisibleProperty()),
            drones(context),
            toggle("show-plan", Feather.MAP, state.planShownProperty()),
            new Spacer(),
            theme(),
            new SettingsMenu(context.language(), state, scene.antialiasingProperty(), pages),
            button("help", Feather.HELP_CIRCLE, pages::toggleHelp),
            toggle("full-screen", Feather.MAXIMIZE, state.fullScreenProperty()),
            new Separator(Orientation.VERTICAL),
            toggle("show-log", Feather.TERMINAL, state.logShownProperty()),
            toggle("show-network", Feather.WIFI, state.networkControlsShownProperty()));
  }

  /** The menu of scenarios. */
  public ScenarioMenu scenarios() {
    return scenarios;
  }

  private HBox views() {
    HBox views =
        new HBox(
            view("view-front", () -> scene.camera().front()),
            view("view-side", () -> scene.camera().side()),
            view("view-top", () -> scene.camera().top()),
            view("view-chase", () -> scene.camera().chase()),
            view("view-reset", () -> scene.camera().reset()));
    views.setAlignment(Pos.CENTER);
    for (Node view : views.getChildren()) {
      view.getStyleClass().add(Styles.CENTER_PILL);
    }
    firstAndLast(views, Styles.LEFT_PILL, Styles.RIGHT_PILL);
    return views;
  }

  private static void firstAndLast(HBox group, String first, String last) {
    Node firstNode = group.getChildren().get(0);
    Node lastNode = group.getChildren().get(group.getChildren().size() - 1);
    firstNode.getStyleClass().remove(Styles.CENTER_PILL);
    firstNode.getStyleClass().add(first);
    lastNode.getStyleClass().remove(Styles.CENTER_PILL);
    lastNode.getStyleClass().add(last);
  }

  private Button view(String id, Runnable look) {
    Button button = new Button();
    button.textProperty().bind(messages.text(id));
    return prepared(
        button,
        id,
        () -> {
          scene.viewCameraProperty().set(ViewCamera.SIMULATOR);
          look.run();
        });
  }

  private ToggleButton droneCamera() {
    ToggleButton button = new ToggleButton("", new FontIcon(Feather.CAMERA));
    button.getStyleClass().addAll(Styles.BUTTON_ICON, Styles.FLAT);
    scene.viewCameraProperty().subscribe(camera -> button.setSelected(camera == ViewCamera.DRONE));
    return prepared(
        button,
        "view-drone",
        () ->
            scene
                .viewCameraProperty()
                .set(button.isSelected() ? ViewCamera.DRONE : ViewCamera.SIMULATOR));
  }

  private ToggleButton drones(ViewContext context) {
    ToggleButton button = toggle("show-drones", Feather.LIST, state.dronesShownProperty());
    boolean several = context.simulation().drones().size() > 1;
    button.setVisible(several);
    button.setManaged(several);
    return button;
  }

  private Button theme() {
    FontIcon icon = new FontIcon(Feather.MOON);
    state
        .themeProperty()
        .subscribe(theme -> icon.setIconCode(theme == Theme.LIGHT ? Feather.MOON : Feather.SUN));
    Button button = new Button("", icon);
    button.getStyleClass().addAll(Styles.BUTTON_ICON, Styles.FLAT);
    return prepared(
        button, "theme", () -> state.themeProperty().set(state.themeProperty().get().other()));
  }

  private Button button(String id, Ikon icon, Runnable action) {
    Button button = new Button("", new FontIcon(icon));
    button.getStyleClass().addAll(Styles.BUTTON_ICON, Styles.FLAT);
    return prepared(button, id, action);
  }

  private ToggleButton toggle(String id, Ikon icon, Property<Boolean> state) {
    ToggleButton button = new ToggleButton("", new FontIcon(icon));
    button.getStyleClass().addAll(Styles.BUTTON_ICON, Styles.FLAT);
    button.selectedProperty().bindBidirectional(state);
    return prepared(button, id, () -> {});
  }

  private <B extends ButtonBase> B prepared(B button, String id, Runnable action) {
    button.setId(id);
    button.getStyleClass().add(Styles.SMALL);
    Tooltips.install(button, messages.text(id + "-tip"));
    button.accessibleTextProperty().bind(messages.text(id + "-tip"));
    button.setFocusTraversable(false); // the keys belong to the 3D scene
    if (button.getGraphic() != null) {
      button.setContentDisplay(ContentDisplay.GRAPHIC_ONLY);
    }
    button.setOnAction(event -> action.run());
    return button;
  }
}
