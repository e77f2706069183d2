(* Functions of the checker that Coq does bit by bit, by Zarith: proofs/coq/verified/Faster.v has their equations. *)

let digits m nb = Z.add nb (Z.of_int (Z.numbits m - 1))
let division a b = if Z.sign b = 0 then (Z.zero, a) else let q = Z.fdiv a b in (q, Z.sub a (Z.mul b q))
let shifted_left m d = if Z.sign d > 0 then Z.shift_left m (Z.to_int d) else Z.one

(* To the right, with the place of what is cut off: [clean] says that nothing was cut off before. *)
let shifted m d clean ~exact ~below ~half ~above =
  let n = if Z.sign d > 0 then Z.to_int d else max_int in
  let q = if n = max_int then Z.zero else Z.shift_right m n in
  if Z.sign q = 0 then (Z.one, exact)
  else begin
    let rest = Z.sub m (Z.shift_left q n) in
    let beyond = Z.testbit rest (n - 1) in
    let clean = clean && Z.popcount rest = if beyond then 1 else 0 in
    (q, if beyond then if clean then half else above else if clean then exact else below)
  end
