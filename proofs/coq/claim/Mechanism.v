(** A mechanism as data, and the table of states of its elements: mechanism.md. *)
From Coq Require Import String List Bool ZArith.
From Slipproof Require Import Text Syntax.
From Slipproof.claim Require Import Expression.
Import ListNotations.

(** Before the motion: at rest, sliding with the sign of its slip, or apart. *)
Inductive start := Rest | SlidesForward | SlidesBackward | Apart.

(** No [friction]: frictionless. The limits are [static] and [kinetic] times N. *)
Record contact := Contact {
  contact_name : string;
  gap_name : string; gap : term;
  slip_name : string; slip : option term;
  friction : option (term * term);
  normal : string; tangent : string;
  begins : start;
  bilateral : bool;
  lift_needs : list string
}.

(** A friction element with a limit of its own. [holder]: it is one of that contact's forces that limits it, as of
    rolling resistance; the number of the contact. *)
Record rubbing := Rubbing {
  rubbing_name : string;
  rub_name : string; rub : term;
  static_limit : term; kinetic_limit : term;
  resistance : string;
  rub_begins : start;
  holder : option nat
}.

Record link_element := Link { link_name : string; zero : term; link_force : string }.

(** [by_virtual_work]: the equations are those of [motion], one for each acceleration, without the forces of contacts,
    friction elements and links. Domains are conditions on the parameters; [assumptions] are relations between them. *)
Record mechanism := Mechanism {
  parameters : list (string * condition);
  angles : list (string * string * condition);
  assumptions : list condition;
  definitions : list (string * term);
  load : option (string * condition);
  accelerations : list string;
  forces : list string;
  by_virtual_work : bool;
  equations : list (string * term * term);
  contacts : list contact;
  rubbings : list rubbing;
  links : list link_element
}.

(** The forces of the elements, after those of no element; the unknowns of a motion. *)
Definition unknowns (m : mechanism) : list string :=
  accelerations m ++ forces m
  ++ flat_map (fun c => normal c :: match friction c with Some _ => [tangent c] | None => [] end) (contacts m)
  ++ map resistance (rubbings m) ++ map link_force (links m).

(** Gaps and slips by name. *)
Definition quantities (m : mechanism) : list (string * term) :=
  flat_map (fun c => (gap_name c, gap c) :: match slip c with Some e => [(slip_name c, e)] | None => [] end) (contacts m)
  ++ map (fun r => (rub_name r, rub r)) (rubbings m).

(** States *)

Inductive state := Stick | SlipForward | SlipBackward | Lift | Touch
                 | PulledStick | PulledForward | PulledBackward | Free.
Definition mode := list state.

Definition same_state (s t : state) : bool :=
  match s, t with
  | Stick, Stick | SlipForward, SlipForward | SlipBackward, SlipBackward | Lift, Lift | Touch, Touch
  | PulledStick, PulledStick | PulledForward, PulledForward | PulledBackward, PulledBackward | Free, Free => true
  | _, _ => false
  end.

(** [given]: the parameters that a scene gives. *)
Definition may_lift (given : list string) (c : contact) : bool :=
  negb (bilateral c) && forallb (fun need => existsb (String.eqb need) given) (lift_needs c).

(** The states of a contact with friction, or of a friction element, that does not open. *)
Definition touching_states (s : start) : list state :=
  match s with
  | Rest => [Stick; SlipForward; SlipBackward]
  | SlidesForward => [SlipForward]
  | SlidesBackward => [SlipBackward]
  | Apart => []
  end.
Definition pulled (s : state) : state :=
  match s with Stick => PulledStick | SlipForward => PulledForward | SlipBackward => PulledBackward | s => s end.

Definition contact_states (given : list string) (c : contact) : list state :=
  match friction c, begins c with
  | _, Apart => [Lift]
  | None, _ => Touch :: if may_lift given c then [Lift] else []
  | Some _, s =>
      touching_states s ++ (if bilateral c then map pulled (touching_states s) else [])
      ++ if may_lift given c then [Lift] else []
  end.

(** A friction element that a contact holds is free where the contact lifts, and pulled where it is; a frictionless
    guide is in one state, whatever the sign of its force. *)
Definition is_pulled (s : state) : bool :=
  match s with PulledStick | PulledForward | PulledBackward => true | _ => false end.
Definition rubbing_states (cs : list contact) (contact_mode : list state) (r : rubbing) : list state :=
  let pushing := touching_states (rub_begins r) in
  match holder r with
  | None => pushing
  | Some i =>
      match nth_error cs i, nth_error contact_mode i with
      | Some _, Some Lift => [Free]
      | Some c, Some Touch => pushing ++ if bilateral c then map pulled pushing else []
      | Some _, Some s => if is_pulled s then map pulled pushing else pushing
      | _, _ => []
      end
  end.

(** Equations and conditions; strictly, > for >= and < for <=. *)
Section States.
Variable strict : bool.
Definition at_least (a b : term) : condition := Compare a [(if strict then Gt else Ge, b)].
Definition at_most (a b : term) : condition := Compare a [(if strict then Lt else Le, b)].
Definition equal (a b : term) : condition := Compare a [(Eq, b)].
Definition nought : term := Number 0.

(** Against a limit, mu_k N or the element's own: the slip has the sign of its state, unless it slides already. *)
Definition slips (already : bool) (s : state) (sliding force kinetic : term) : list condition :=
  match s with
  | SlipForward | PulledForward => equal force (Minus kinetic) :: if already then [] else [at_least sliding nought]
  | SlipBackward | PulledBackward => equal force kinetic :: if already then [] else [at_most sliding nought]
  | _ => []
  end.
Definition slides (s : start) : bool := match s with SlidesForward | SlidesBackward => true | _ => false end.

(** Sticks: the slip is 0, and the force within the static limit. *)
Definition sticks (sliding force static : term) : list condition :=
  [equal sliding nought; at_most force static; at_least force (Minus static)].

Definition contact_conditions (c : contact) (s : state) : list condition :=
  let gap := Symbol (gap_name c) in
  let slip := Symbol (slip_name c) in
  let N := Symbol (normal c) in
  let S := Symbol (tangent c) in
  (* A guide that pulls: N <= 0, and -N for N in the friction law. *)
  let pressing := if is_pulled s then Minus N else N in
  let static := match friction c with Some mu => Product (fst mu) pressing | None => nought end in
  let kinetic := match friction c with Some mu => Product (snd mu) pressing | None => nought end in
  match s with
  | Lift =>
      equal N nought :: (match friction c with Some _ => [equal S nought] | None => [] end)
      ++ match begins c with Apart => [] | _ => [at_least gap nought] end
  | Touch => equal gap nought :: if bilateral c then [] else [at_least N nought]
  | Stick | PulledStick => equal gap nought :: at_least pressing nought :: sticks slip S static
  | _ => equal gap nought :: at_least pressing nought :: slips (slides (begins c)) s slip S kinetic
  end.

Definition rubbing_conditions (r : rubbing) (s : state) : list condition :=
  let sliding := Symbol (rub_name r) in
  let S := Symbol (resistance r) in
  let static := if is_pulled s then Minus (static_limit r) else static_limit r in
  let kinetic := if is_pulled s then Minus (kinetic_limit r) else kinetic_limit r in
  match s with
  | Free => [equal S nought]
  | Stick | PulledStick => at_least static nought :: at_least kinetic nought :: sticks sliding S static
  | _ => at_least static nought :: at_least kinetic nought :: slips (slides (rub_begins r)) s sliding S kinetic
  end.
End States.

(** Modes: a state for each contact, then for each friction element. [None]: it is no mode, or not modelled. *)
Definition state_in (s : state) (ss : list state) : bool := existsb (same_state s) ss.

Fixpoint of_contacts (strict : bool) (given : list string) (cs : list contact) (m : mode) : option (list condition * mode) :=
  match cs, m with
  | [], _ => Some ([], m)
  | c :: cs, s :: m =>
      require state_in s (contact_states given c) in
      let* rest := of_contacts strict given cs m in Some (contact_conditions strict c s ++ fst rest, snd rest)
  | _ :: _, [] => None
  end.
Fixpoint of_rubbings (strict : bool) (cs : list contact) (contact_mode : mode) (rs : list rubbing) (m : mode) : option (list condition) :=
  match rs, m with
  | [], [] => Some []
  | r :: rs, s :: m =>
      require state_in s (rubbing_states cs contact_mode r) in
      let* rest := of_rubbings strict cs contact_mode rs m in Some (rubbing_conditions strict r s ++ rest)
  | _, _ => None
  end.
Definition mode_conditions (strict : bool) (given : list string) (m : mechanism) (md : mode) : option (list condition) :=
  let* contact_part := of_contacts strict given (contacts m) md in
  let* rubbing_part := of_rubbings strict (contacts m) md (rubbings m) (snd contact_part) in Some (fst contact_part ++ rubbing_part).

(** Motion: by virtual work, the force of an element acts on the acceleration [a] with its slope in [a]: d gap/d a N,
    d slip/d a S, d zero/d a R. No slope is 0. *)
Fixpoint slope (a : string) (e : term) : option term :=
  match e with
  | Symbol name => if String.eqb name a then Some (Number 1) else None
  | Minus x => let* d := slope a x in Some (Minus d)
  | Plus x y =>
      match slope a x, slope a y with Some d, Some f => Some (Plus d f) | Some d, None | None, Some d => Some d | None, None => None end
  | Difference x y =>
      match slope a x, slope a y with
      | Some d, Some f => Some (Difference d f) | Some d, None => Some d | None, Some f => Some (Minus f) | None, None => None
      end
  | Product x y =>
      match slope a x, slope a y with
      | Some d, Some f => Some (Plus (Product d y) (Product x f))
      | Some d, None => Some (Product d y) | None, Some f => Some (Product x f) | None, None => None
      end
  | Quotient x y => let* d := slope a x in Some (Quotient d y)
  | Power x 1 => slope a x
  | _ => None
  end.

(** What the elements do, each with its force, in the order in which they act. *)
Definition works (m : mechanism) : list (term * string) :=
  flat_map (fun c => (gap c, normal c) :: match slip c, friction c with Some e, Some _ => [(e, tangent c)] | _, _ => [] end)
           (contacts m)
  ++ map (fun r => (rub r, resistance r)) (rubbings m) ++ map (fun l => (zero l, link_force l)) (links m).

Fixpoint acting (a : string) (right : term) (ws : list (term * string)) : term :=
  match ws with
  | [] => right
  | (e, force) :: ws =>
      acting a (match slope a e with Some d => Plus right (Product d (Symbol force)) | None => right end) ws
  end.

Definition dynamics (m : mechanism) : list condition :=
  map (fun '(a, x, y) => equal x (if by_virtual_work m then acting a y (works m) else y)) (equations m)
  ++ map (fun l => equal (zero l) nought) (links m).
