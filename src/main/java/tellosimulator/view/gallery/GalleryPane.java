package tellosimulator.view.gallery;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import javafx.application.Platform;
import javafx.css.PseudoClass;
import javafx.geometry.Orientation;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.OverrunStyle;
import javafx.scene.control.ScrollPane;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.ColumnConstraints;
import javafx.scene.layout.GridPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.concurrent.Worker;
import tellosimulator.scenario.Gallery;
import tellosimulator.scenario.Scenario;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * Shows the scenarios that come with the program as cards, and below them the recently opened
 * files. Confined to the JavaFX thread.
 */
public final class GalleryPane extends VBox {

  /** The gallery's state, which is kept when the scenario changes. */
  public record Offer(RoomPictures pictures, RecentFiles recent, SolvedScenarios solved) {}

  /**
   * The actions for the chosen item.
   *
   * @param known opens a scenario that comes with the program, given its short name
   * @param file opens a file
   */
  public record OptionValue(Consumer<String> known, Consumer<Path> file) {}

  private final List<ScenarioCard> cards = new ArrayList<>();

  public GalleryPane(Language language, Offer offer, OptionValue choice) {
    Nodes.named(this, "gallery", "gallery");
    getStylesheets().add(GalleryPane.class.getResource("gallery.css").toExternalForm());
    for (String name : Gallery.NAMES) {
      Gallery.find(name).ifPresent(known -> cards.add(card(language, name, known, choice)));
    }
    for (ScenarioCard card : cards) {
      String name = card.getId().substring("scenario-".length());
      card.picture().imageProperty().bind(offer.pictures().picture(name));
      card.setSolved(offer.solved().contains(name));
    }
    CardGrid grid = new CardGrid(cards);
    ScrollPane scroll = new FittingScrollPane(grid);
    scroll.setFitToWidth(true);
    scroll.setHbarPolicy(ScrollPane.ScrollBarPolicy.NEVER);
    VBox.setVgrow(scroll, Priority.ALWAYS);
    getChildren().add(scroll);
    List<Path> recent = offer.recent().filesProperty().getValue();
    if (!recent.isEmpty()) {
      Messages messages = language.messages(GalleryPane.class);
      Label heading = messages.label("recent", "heading");
      getChildren().addAll(heading, new RecentList(language, recent, choice.file()));
    }
  }

  /**
   * A scroll pane whose preferred height equals the height of its content at the given width, even
   * at the first layout.
   */
  private static final class FittingScrollPane extends ScrollPane {

    FittingScrollPane(CardGrid grid) {
      super(grid);
    }

    @Override
    public Orientation getContentBias() {
      return Orientation.HORIZONTAL;
    }

    @Override
    protected double computePrefHeight(double width) {
      return width < 0
          ? super.computePrefHeight(width)
          : Math.ceil(getContent().prefHeight(width) + snappedTopInset() + snappedBottomInset());
    }
  }

  private static ScenarioCard card(
      Language language, String name, Scenario scenario, OptionValue choice) {
    ScenarioCard card =
        Nodes.named(
            new ScenarioCard(language, scenario.description(), () -> choice.known().accept(name)),
            "scenario-" + name);
    return card;
  }

  /** Returns the node that gets the focus when the gallery opens. */
  public Node firstCard() {
    return cards.get(0);
  }

  /**
   * A grid of cards with as many columns as fit, up to five; arrow keys, Home and End move the
   * focus between the cards. Confined to the JavaFX thread.
   */
  private static final class CardGrid extends GridPane {

    /** Minimum width of a card [px]. Decided: five cards fit into 1024 pixels. */
    private static final double LEAST_WIDTH = 165;

    private static final int MOST_COLUMNS = 5;

    private final List<? extends Node> cards;
    private int columns;

    CardGrid(List<? extends Node> cards) {
      this.cards = List.copyOf(cards);
      getStyleClass().add("card-grid");
      arrange(MOST_COLUMNS);
      widthProperty().subscribe(width -> arrange(columnsFor(width.doubleValue())));
      addEventFilter(KeyEvent.KEY_PRESSED, this::moveFocus);
    }

    private static int columnsFor(double width) {
      return width <= 0
          ? MOST_COLUMNS
          : (int) Math.max(1, Math.min(MOST_COLUMNS, Math.floor(width / LEAST_WIDTH)));
    }

    private void arrange(int newColumns) {
      if (newColumns == columns) {
        return;
      }
      columns = newColumns;
      getChildren().clear();
      getColumnConstraints().clear();
      for (int i = 0; i < columns; i++) {
        ColumnConstraints column = new ColumnConstraints();
        column.setPercentWidth(100.0 / columns);
        getColumnConstraints().add(column);
      }
      for (int i = 0; i < cards.size(); i++) {
        add(cards.get(i), i % columns, i / columns);
      }
    }

    private void moveFocus(KeyEvent key) {
      int focused = focused();
      if (focused < 0) {
        return;
      }
      int wanted =
          switch (key.getCode()) {
            case LEFT -> focused - 1;
            case RIGHT -> focused + 1;
            case UP -> focused - columns;
            case DOWN -> focused + columns;
            case HOME -> 0;
            case END -> cards.size() - 1;
            default -> focused;
          };
      if (wanted != focused || key.getCode().isArrowKey()) {
        key.consume();
      }
      if (wanted >= 0 && wanted < cards.size()) {
        cards.get(wanted).requestFocus();
      }
    }

    private int focused() {
      for (int i = 0; i < cards.size(); i++) {
        if (cards.get(i).isFocused()) {
          return i;
        }
      }
      return -1;
    }
  }

  /**
   * The recently opened files as buttons in a row. A separate thread checks which of them are
   * missing, because a drive may be slow. Confined to the JavaFX thread.
   */
  private static final class RecentList extends HBox {

    private static final ErrorPolicy FAILED =
        ErrorPolicy.finish("The recent files could not be looked for");

    private static final PseudoClass MISSING = PseudoClass.getPseudoClass("missing");

    private final Messages messages;
    private final List<Path> files;
    private final List<Button> buttons = new ArrayList<>();

    /**
     * @param files the files, each of which gets a button
     * @param opener opens a file
     */
    RecentList(Language language, List<Path> files, Consumer<Path> opener) {
      this.messages = language.messages(RecentList.class);
      this.files = List.copyOf(files);
      Nodes.named(this, "recent-files", "recent-files");
      for (Path file : files) {
        buttons.add(button(file, opener));
      }
      getChildren().addAll(buttons);
      Worker.once("recent-files", FAILED, this::lookForThem);
    }

    private Button button(Path file, Consumer<Path> opener) {
      Button button =
          Nodes.named(
              new Button(String.valueOf(file.getFileName()), new FontIcon(Feather.FILE)),
              "recent-" + (buttons.size() + 1));
      button.setTextOverrun(OverrunStyle.CENTER_ELLIPSIS);
      button.setAlignment(Pos.CENTER_LEFT);
      button.setMaxWidth(Double.MAX_VALUE);
      button.setPrefWidth(0); // gives all buttons the same width
      HBox.setHgrow(button, Priority.ALWAYS);
      Nodes.described(button, messages.text("file", file));
      button.setOnAction(pressed -> opener.accept(file));
      return button;
    }

    /** Finds missing files. Called on a separate thread. */
    private void lookForThem() {
      Set<Path> gone = new HashSet<>(files);
      gone.removeIf(Files::exists);
      Platform.runLater(() -> mark(gone));
    }

    private void mark(Set<Path> gone) {
      for (int i = 0; i < buttons.size(); i++) {
        Path file = files.get(i);
        if (gone.contains(file)) {
          Button button = buttons.get(i);
          button.pseudoClassStateChanged(MISSING, true);
          button.setGraphic(new FontIcon(Feather.ALERT_CIRCLE));
          button.textProperty().bind(messages.text("missing", file.getFileName()));
          button.accessibleTextProperty().bind(messages.text("missing", file));
        }
      }
    }
  }
}
