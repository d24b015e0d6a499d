package tellosimulator.view.replay;

import atlantafx.base.controls.Spacer;
import atlantafx.base.theme.Styles;
import java.util.List;
import javafx.collections.FXCollections;
import javafx.collections.ObservableList;
import javafx.collections.transformation.FilteredList;
import javafx.geometry.Pos;
import javafx.scene.control.IndexedCell;
import javafx.scene.control.Label;
import javafx.scene.control.ListView;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.skin.VirtualFlow;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import tellosimulator.report.ReportEntries;
import tellosimulator.report.ReportEntry;
import tellosimulator.report.ReportTexts;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * The commands of a flight with their replies, and the events of the flight. The list follows the
 * playback, and selecting an entry seeks to its moment. Confined to the JavaFX thread.
 */
final class EntryList extends VBox {

  /** Tolerance of moments [s]. An entry counts as begun this long before its moment. */
  private static final double NEARLY = 0.005;

  private final FxReplay replay;
  private final Playback playback;
  private final Language language;
  private final Messages messages;
  private final ObservableList<ReportEntry> all = FXCollections.observableArrayList();
  private final FilteredList<ReportEntry> entries = new FilteredList<>(all);
  private final ListView<ReportEntry> list = Nodes.named(new ListView<>(entries), "entry-list");
  private final ToggleButton problems =
      Nodes.named(new ToggleButton(), "only-problems", Styles.SMALL);
  private boolean following;

  EntryList(FxReplay replay, Language language) {
    this.replay = replay;
    this.playback = replay.playback();
    this.language = language;
    this.messages = language.messages(EntryList.class);
    setId("entries");
    setMinHeight(0);
    initializeParts();
    layoutParts();
    setupEventHandlers();
  }

  /** Returns the moments of all problems [s]. */
  List<Double> problems() {
    return all.stream().filter(ReportEntry::wrong).map(ReportEntry::time).toList();
  }

  /**
   * Seeks to the next or the previous entry. If there is none, seeks to the end or the beginning of
   * the flight.
   *
   * @param step 1 for the next entry, -1 for the previous one
   */
  void jump(int step) {
    double time = playback.time();
    int index = step > 0 ? lastBy(time + NEARLY) + 1 : lastBy(time - NEARLY);
    double edge = step > 0 ? playback.end() : playback.begin();
    boolean exists = index >= 0 && index < entries.size();
    playback.seek(exists ? entries.get(index).time() : edge);
  }

  private void initializeParts() {
    list.setCellFactory(
        view ->
            new EntryCell(
                view,
                messages,
                replay.simulation().drones().size() > 1,
                entry -> playback.seek(entry.time())));
    list.setPlaceholder(messages.label("no-entries"));
    list.accessibleTextProperty().bind(messages.text("entries"));
    list.setMinHeight(0);
    problems.textProperty().bind(messages.text("only-problems"));
    Tooltips.install(problems, messages.text("only-problems.tooltip"));
  }

  private void layoutParts() {
    Label title = messages.label("entries-title", "heading");
    HBox head = new HBox(title, new Spacer(), Nodes.unshrinkable(problems));
    head.setAlignment(Pos.CENTER_LEFT);
    Nodes.styled(head, "entries-head");
    VBox.setVgrow(list, Priority.ALWAYS);
    getChildren().addAll(head, list);
  }

  private void setupEventHandlers() {
    language.localeProperty().subscribe(locale -> translate());
    problems
        .selectedProperty()
        .subscribe(
            only -> {
              following = true;
              entries.setPredicate(entry -> !only || entry.wrong());
              following = false;
              follow();
            });
    list.getSelectionModel()
        .selectedItemProperty()
        .addListener((property, before, chosen) -> choose(chosen));
    playback.timeProperty().subscribe(this::follow);
  }

  /** Recreates the entries in the current language. */
  private void translate() {
    following = true;
    ReportTexts texts = new ReportTexts(language.translation());
    all.setAll(new ReportEntries(texts).of(replay.flight().flight()));
    following = false;
    follow();
  }

  private void choose(ReportEntry chosen) {
    if (!following && chosen != null) {
      playback.seek(chosen.time());
    }
  }

  private void follow() {
    if (following) {
      return;
    }
    int index = lastBy(playback.time() + NEARLY);
    if (index == list.getSelectionModel().getSelectedIndex()) {
      return;
    }
    following = true;
    if (index < 0) {
      list.getSelectionModel().clearSelection();
    } else if (!sameMoment(index)) {
      list.getSelectionModel().select(index);
      bringIntoSight(index);
    }
    following = false;
  }

  /**
   * Returns whether the selected entry has the same moment as another one, so that the selection
   * must not change.
   */
  private boolean sameMoment(int index) {
    ReportEntry chosen = list.getSelectionModel().getSelectedItem();
    return chosen != null && chosen.time() == entries.get(index).time();
  }

  /**
   * Returns the index of the last entry that begins at or before the given time [s], or -1 if there
   * is none.
   */
  private int lastBy(double moment) {
    int last = -1;
    while (last + 1 < entries.size() && entries.get(last + 1).time() <= moment) {
      last++;
    }
    return last;
  }

  private void bringIntoSight(int index) {
    if (list.lookup(".virtual-flow") instanceof VirtualFlow<?> flow) {
      IndexedCell<?> first = flow.getFirstVisibleCell();
      IndexedCell<?> last = flow.getLastVisibleCell();
      boolean seen =
          first != null && first.getIndex() < index && last != null && index < last.getIndex();
      if (!seen) {
        list.scrollTo(Math.max(0, index - 1));
      }
    }
  }
}
