package tellosimulator.view.layout;

import atlantafx.base.theme.Styles;
import atlantafx.base.theme.Tweaks;
import java.util.List;
import java.util.Locale;
import javafx.beans.property.Property;
import javafx.beans.value.ObservableValue;
import javafx.scene.control.CheckMenuItem;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.RadioMenuItem;
import javafx.scene.control.ToggleGroup;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.translation.PhraseCatalog;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;
import tellosimulator.view.world.Simulator3DScene;

/** Language, theme, scale, and what else is chosen once. */
final class SettingsMenu extends MenuButton {

  private final Messages messages;

  SettingsMenu(Language language, WindowState state, Simulator3DScene scene, PageOverlay pages) {
    super("", new FontIcon(Feather.SETTINGS));
    messages = language.messages(SettingsMenu.class);
    setId("settings");
    Tooltips.install(this, messages.text("settings"));
    accessibleTextProperty().bind(messages.text("settings"));
    textProperty().bind(messages.text("settings"));
    setContentDisplay(ContentDisplay.GRAPHIC_ONLY);
    getStyleClass().addAll(Styles.BUTTON_ICON, Styles.FLAT, Styles.SMALL, Tweaks.NO_ARROW);
    MenuItem about = new MenuItem();
    about.setId("about");
    about.textProperty().bind(messages.text("about"));
    about.setOnAction(event -> pages.showAbout());
    getItems()
        .setAll(
            choice("language", PhraseCatalog.OFFERED, language.localeProperty()),
            choice("theme", List.of(Theme.values()), state.themeProperty()),
            choice("scale", List.of(UiScale.values()), state.uiScaleProperty()),
            flag("smooth-edges", scene.antialiasingProperty()),
            flag("enlarged-drones", scene.dronesEnlargedProperty()),
            flag("reduced-motion", state.reducedMotionProperty()),
            flag("record-flights", state.flightsRecordedProperty()),
            flag("full-screen", state.fullScreenProperty()),
            flag("projector", state.projectorProperty()),
            about);
  }

  private CheckMenuItem flag(String key, Property<Boolean> value) {
    CheckMenuItem item = new CheckMenuItem();
    item.setId(key);
    item.textProperty().bind(messages.text(key));
    item.selectedProperty().bindBidirectional(value);
    return item;
  }

  private <T> Menu choice(String key, List<T> values, Property<T> chosen) {
    Menu menu = new Menu();
    menu.setId(key);
    menu.textProperty().bind(messages.text(key));
    ToggleGroup group = new ToggleGroup();
    for (T value : values) {
      RadioMenuItem item = new RadioMenuItem();
      String name = value.toString().toLowerCase(Locale.ROOT);
      item.setId(key + "-" + name);
      ObservableValue<String> text = messages.text(key + "-" + name);
      item.textProperty().bind(text);
      item.setToggleGroup(group);
      item.setOnAction(event -> chosen.setValue(value));
      chosen.subscribe(now -> item.setSelected(value.equals(now)));
      menu.getItems().add(item);
    }
    return menu;
  }
}
