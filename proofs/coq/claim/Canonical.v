(** Settings and claims as lines of text, one for each of the files that they come from. A text states the claims whose
    lines, token for token, it consists of. *)
From Coq Require Import String List Bool NArith ZArith DecimalString.
From Slipproof Require Import Text Syntax Print.
From Slipproof.claim Require Import Expression Mechanism Claim.
Import ListNotations.
Local Open Scope string_scope.

Definition print_number (n : N) : string := NilEmpty.string_of_uint (N.to_uint n).

(** No more parentheses than the text needs: sums (4) of products (3) of signed numbers (2) of powers (1) of the rest. *)
Fixpoint print_term (level : nat) (e : term) (after : list string) : list string :=
  let within own body := if Nat.leb own level then body after else "(" :: body (")" :: after) in
  let infix own a sign b l r := within own (fun after => print_term l a (sign :: print_term r b after)) in
  let one name a := name :: "(" :: print_term 4 a (")" :: after) in
  let two name a b := name :: "(" :: print_term 4 a ("," :: print_term 4 b (")" :: after)) in
  match e with
  | Number n => print_number n :: after
  | Symbol name => name :: after
  | Minus a => within 2 (fun after => "-" :: print_term 2 a after)
  | Plus a b => infix 4 a "+" b 4 3
  | Difference a b => infix 4 a "-" b 4 3
  | Product a b => infix 3 a "*" b 3 2
  | Quotient a b => infix 3 a "/" b 3 2
  | Power a k =>
      within 1 (fun after =>
        print_term 0 a ("^" :: if Z.ltb k 0 then "-" :: print_number (Z.abs_N k) :: after else print_number (Z.abs_N k) :: after))
  | Absolute a => one "abs" a
  | Signum a => one "sign" a
  | Minimum a b => two "min" a b
  | Maximum a b => two "max" a b
  end.

(** Disjunctions (3) of conjunctions (2) of negations (1) of comparisons. *)
Fixpoint print_condition (level : nat) (c : condition) (after : list string) : list string :=
  let within own body := if Nat.leb own level then body after else "(" :: body (")" :: after) in
  match c with
  | Constant b => (if b then "true" else "false") :: after
  | Compare a links =>
      print_term 4 a (fold_right (fun l after => print_rel (fst l) :: print_term 4 (snd l) after) after links)
  | Not c => within 1 (fun after => "not" :: print_condition 1 c after)
  | Both c d => within 2 (fun after => print_condition 2 c ("and" :: print_condition 1 d after))
  | Either c d => within 3 (fun after => print_condition 3 c ("or" :: print_condition 2 d after))
  end.

Definition put (words : list string) (c : condition) : list string := words ++ ":" :: print_condition 3 c [].
Definition equals (words : list string) (e : term) : list string := words ++ "=" :: print_term 4 e [].

(** A name that is no word, such as [rear-wheel]. *)
Definition spelled (name : string) : list string := match tokens name "" [] with Some words => words | None => [] end.

Definition print_start (s : start) : list string :=
  match s with Rest => ["rest"] | SlidesForward => ["slides"; "+"] | SlidesBackward => ["slides"; "-"] | Apart => ["open"] end.

Definition print_contact (c : contact) : list (list string) :=
  ("contact" :: print_start (begins c) ++ (if bilateral c then ["bilateral"] else [])
   ++ match lift_needs c with [] => [] | needs => "needs" :: needs end ++ ":" :: spelled (contact_name c))
  :: equals ["gap"; gap_name c] (gap c)
  :: match slip c with Some e => [equals ["slip"; slip_name c] e] | None => [] end
  ++ ["normal"; normal c]
  :: match friction c with
     | Some mu => [["tangent"; tangent c]; equals ["static"] (fst mu); equals ["kinetic"] (snd mu)]
     | None => []
     end.

Definition print_rubbing (r : rubbing) : list (list string) :=
  ("friction" :: print_start (rub_begins r)
   ++ match holder r with Some i => ["at"; print_number (N.of_nat i)] | None => [] end
   ++ ":" :: spelled (rubbing_name r))
  :: equals ["slip"; rub_name r] (rub r) :: ["tangent"; resistance r] :: equals ["static"] (static_limit r)
  :: [equals ["kinetic"] (kinetic_limit r)].

Definition print_mechanism (m : mechanism) : list (list string) :=
  map (fun p => put ["parameter"; fst p] (snd p)) (parameters m)
  ++ map (fun '(c, n, d) => put ["angle"; c; n] d) (angles m)
  ++ map (put ["assume"]) (assumptions m)
  ++ map (fun d => equals ["let"; fst d] (snd d)) (definitions m)
  ++ match load m with Some l => [put ["load"; fst l] (snd l)] | None => [] end
  ++ ("accelerations" :: accelerations m) :: ("forces" :: forces m)
  :: [if by_virtual_work m then "motion" else "equations"]
  :: map (fun '(name, x, y) => "equation" :: spelled name ++ ":" :: print_term 4 x ("=" :: print_term 4 y [])) (equations m)
  ++ flat_map print_contact (contacts m) ++ flat_map print_rubbing (rubbings m)
  ++ map (fun l => "link" :: link_force l :: spelled (link_name l) ++ ":" :: print_term 4 (zero l) []) (links m).

Definition print_setting (number : nat) (s : setting) : list (list string) :=
  ["setting"; print_number (N.of_nat number); if strict s then "strict" else "closed"]
  :: map (fun p => put ["parameter"; fst p] (snd p)) (paper_parameters s)
  ++ map (fun '(c, n, d) => put ["angle"; c; n] d) (paper_angles s)
  ++ put ("force" :: if String.eqb (force s) "" then [] else [force s]) (force_domain s)
  :: map (fun d => equals ["let"; fst d] (snd d)) (paper_definitions s)
  ++ map (fun d => equals ["scene"; fst d] (snd d)) (scene s)
  ++ ["mechanism"] :: print_mechanism (of_mechanism s).

Definition print_state (s : state) : list string :=
  match s with
  | Stick => ["stick"] | SlipForward => ["slip"; "+"] | SlipBackward => ["slip"; "-"] | Lift => ["lift"] | Touch => ["touch"]
  | PulledStick => ["stick"; "~"] | PulledForward => ["slip"; "+"; "~"] | PulledBackward => ["slip"; "-"; "~"] | Free => ["free"]
  end.
Fixpoint print_mode (m : mode) : list string :=
  match m with [] => [] | [s] => print_state s | s :: m => print_state s ++ "/" :: print_mode m end.
Definition print_modes (ms : list mode) : list (list string) := map (fun m => "mode" :: print_mode m) ms.

Definition print_model (model : option (option mode)) : list (list string) :=
  match model with
  | Some None => [["of"; "the"; "model"]]
  | Some (Some m) => ["of"; "the"; "model"] :: print_modes [m]
  | None => []
  end.

Definition print_reference (word : string) (r : reference) : list (list string) :=
  [put [word; "region"] (fst r); put [word; "forces"] (snd r)].

Definition print_kind (k : kind) : list (list string) :=
  match k with
  | Interval m => ["interval"] :: print_modes [m]
  | Impossible ms => ["impossible"] :: print_modes ms
  | Formula ms holds => ["formula"] :: print_modes ms ++ [put ["holds"] holds]
  | Motions ms => ["motions"] :: print_modes ms
  | Exists ms => ["exists"] :: print_modes ms
  | Equivalence holds => [["equivalence"]; put ["holds"] holds]
  | Cover rs => ["cover"] :: flat_map (print_reference "one") rs
  | Consequence model hs es => ["consequence"] :: print_model model ++ map (put ["given"]) hs ++ map (put ["follows"]) es
  | System model given hs es =>
      ["system"] :: print_model model ++ map (put ["given"]) given ++ map (put ["from"]) hs ++ map (put ["follows"]) es
  | Unique claims except ms =>
      ["unique"] :: flat_map (fun i => ("one" :: "mode" :: print_mode (fst i)) :: print_reference "one" (snd i)) claims
      ++ flat_map (print_reference "except") except ++ print_modes ms
  | Limit p holds from =>
      ["limit"; p] :: put ["holds"] holds :: match from with Some e => [equals ["from"] e] | None => [] end
  | ForceCover rs => ["force"; "-"; "cover"] :: flat_map (print_reference "one") rs
  end.

(** A file of settings, from 0, and of claims in one of them each. The name of a claim is made of tokens, as [A - 1]. *)
Record named_claim := Named {
  name_of : list string; setting_number : nat; kind_of_it : kind; its_region : condition; its_forces : condition
}.
Record file := File { settings : list setting; claims : list named_claim }.

Definition claim_of (f : file) (n : named_claim) : option claim :=
  let* s := nth_error (settings f) (setting_number n) in Some (Claim s (kind_of_it n) (its_region n) (its_forces n)).

Definition print_claim (n : named_claim) : list (list string) :=
  ("claim" :: name_of n ++ ["in"; print_number (N.of_nat (setting_number n))])
  :: print_kind (kind_of_it n) ++ [put ["region"] (its_region n); put ["forces"] (its_forces n)].

Definition print_file (f : file) : list (list string) :=
  concat (map (fun ns => print_setting (fst ns) (snd ns)) (combine (seq 0 (length (settings f))) (settings f)))
  ++ flat_map print_claim (claims f).

Definition states_claims (text : string) (f : file) : Prop :=
  exists header body, lines text = Some (header :: body) /\ raw header = "slipproof-claims 1" /\ map words body = print_file f.
