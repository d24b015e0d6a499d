package tellosimulator.view.layout;

import atlantafx.base.theme.Styles;
import java.util.Locale;
import java.util.Optional;
import javafx.beans.binding.Bindings;
import javafx.beans.binding.StringBinding;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.scene.control.CheckMenuItem;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.RadioMenuItem;
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.control.ToggleGroup;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.scenery.orbit.RoomView;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.text.Messages;
import tellosimulator.view.world.Simulator3DScene;
import tellosimulator.view.world.ViewCamera;

/**
 * A button with the name of the current view, and a menu of all views with their keys. Confined to
 * the JavaFX thread.
 */
final class CameraMenu extends MenuButton {

  /** The key of the text for a view that was set with the mouse. */
  private static final String OWN = "view-own";

  /** The key of the text for the view of the drone's camera. */
  private static final String DRONE = "view-drone";

  private final Messages messages;
  private final Simulator3DScene scene;
  private final ReadOnlyObjectProperty<Optional<RoomView>> view;
  private final ToggleGroup views = new ToggleGroup();

  CameraMenu(Messages messages, Simulator3DScene scene) {
    super("", new FontIcon(Feather.VIDEO));
    this.messages = messages;
    this.scene = scene;
    this.view = scene.camera().viewProperty();
    Nodes.named(this, "camera", Styles.FLAT, Styles.SMALL);
    Tooltips.install(this, messages.text("camera-tip"));
    StringBinding name = messages.text(OWN);
    textProperty()
        .bind(
            Bindings.createStringBinding(
                () -> messages.now(shownKey()), name, view, scene.viewCameraProperty()));
    accessibleTextProperty().bind(messages.text("camera-accessible", textProperty()));
    for (RoomView each : RoomView.values()) {
      add(key(each), WindowKey.of(each), () -> scene.look(each));
    }
    add(DRONE, WindowKey.DRONE_CAMERA, () -> scene.viewCameraProperty().set(ViewCamera.DRONE));
    MenuItem fit = named(new MenuItem(), "menu-fit", WindowKey.FIT);
    fit.setOnAction(event -> scene.fit());
    CheckMenuItem follow = named(new CheckMenuItem(), "menu-follow", WindowKey.FOLLOW);
    follow.selectedProperty().bindBidirectional(scene.camera().followingProperty());
    getItems().addAll(new SeparatorMenuItem(), fit, follow);
    view.subscribe(this::mark);
    scene.viewCameraProperty().subscribe(this::mark);
  }

  private void add(String key, WindowKey shortcut, Runnable action) {
    RadioMenuItem item = named(new RadioMenuItem(), key, shortcut);
    item.setToggleGroup(views);
    item.setOnAction(
        event -> {
          action.run();
          mark();
        });
    getItems().add(item);
  }

  private <I extends MenuItem> I named(I item, String key, WindowKey shortcut) {
    item.setId(key);
    StringBinding name = messages.text(key);
    item.textProperty()
        .bind(
            Bindings.createStringBinding(
                () -> messages.now("menu-key", name.get(), shortcut.symbol(messages)), name));
    return item;
  }

  /** Selects the item of the current view, or no item if the view was set with the mouse. */
  private void mark() {
    String shown = shownKey();
    views.selectToggle(
        views.getToggles().stream()
            .filter(item -> shown.equals(((MenuItem) item).getId()))
            .findFirst()
            .orElse(null));
  }

  private String shownKey() {
    return scene.viewCameraProperty().get() == ViewCamera.DRONE
        ? DRONE
        : view.get().map(CameraMenu::key).orElse(OWN);
  }

  private static String key(RoomView view) {
    return "view-" + view.name().toLowerCase(Locale.ROOT);
  }
}
